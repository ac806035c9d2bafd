#include "stages/export/ros_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace morphe::exports {
namespace {

/// A YAML string in double quotes; other control characters do not stand in names of joints.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

void add_row(const char* key, const JointRows& rows, Eigen::Index row, std::string& text) {
  fmt::format_to(std::back_inserter(text), "    {}: [", key);
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    fmt::format_to(std::back_inserter(text), "{}{:#.17g}", j > 0 ? ", " : "", rows(row, j));
  }
  text += "]\n";
}

}  // namespace

std::string ros_trajectory(const RobotTable& robot, const Trajectory& t) {
  std::string text = "header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: \"base\"\njoint_names:\n";
  for (const std::string& joint : robot.joint_names) text += "  - " + quoted(joint) + "\n";
  text += "points:\n";
  constexpr std::int64_t kSecond = 1'000'000'000;
  std::int64_t last_ns = -1;
  for (std::size_t i = 0; i < t.samples(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    text += "  -\n";
    add_row("positions", t.position, row, text);
    add_row("velocities", t.velocity, row, text);
    add_row("accelerations", t.acceleration, row, text);
    last_ns = std::max<std::int64_t>(last_ns + 1, std::llround(t.time[i] * kSecond));
    fmt::format_to(std::back_inserter(text), "    time_from_start: {{sec: {}, nanosec: {}}}\n",
                   last_ns / kSecond, last_ns % kSecond);
  }
  return text;
}

}  // namespace morphe::exports
