#include "stages/export/ros_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace morphe::exports {
namespace {

/// Returns a string in double quotes, in the syntax common to YAML and JSON.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(text), "\\u{:04x}", static_cast<unsigned char>(c));
      continue;
    }
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

void add_number(double value, std::string& text) {
  std::string digits = fmt::format("{}", value);
  if (digits.find('.') == std::string::npos)
    digits.insert(std::min(digits.find('e'), digits.size()), ".0");
  text += digits;
}

/// The keys of a mapping in flow style, quoted in JSON.
struct Keys {
  const char* quote;
  std::string operator()(const char* key) const { return fmt::format("{0}{1}{0}: ", quote, key); }
};

/// Adds one row as a list, after a key that ends with a colon.
void add_row(const std::string& key, const JointRows& rows, Eigen::Index row, std::string& text) {
  text += key + "[";
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    if (j > 0) text += ", ";
    add_number(rows(row, j), text);
  }
  text += "], ";
}

/// Adds one line in flow style per point: `prefix`, the point, and `separator` except after the
/// last.
void add_points(const Trajectory& t, const Keys& key, const char* prefix, const char* separator,
                std::string& text) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  std::int64_t last_ns = -1;
  for (int i = 0; i < std::ssize(t.time); ++i) {
    text += prefix;
    text += "{";
    add_row(key("positions"), t.position, i, text);
    add_row(key("velocities"), t.velocity, i, text);
    add_row(key("accelerations"), t.acceleration, i, text);
    last_ns = std::max<std::int64_t>(last_ns + 1, std::llround(t.time[i] * kSecond));
    fmt::format_to(std::back_inserter(text), "{}{{{}{}, {}{}}}}}", key("time_from_start"),
                   key("sec"), last_ns / kSecond, key("nanosec"), last_ns % kSecond);
    if (i + 1 < std::ssize(t.time)) text += separator;
    text += "\n";
  }
}

std::string joined_names(const JointGroup& group) {
  std::string text;
  for (const std::string& name : group.names) text += (text.empty() ? "" : ", ") + quoted(name);
  return text;
}

}  // namespace

std::string ros_trajectory_yaml(const JointGroup& group, const Trajectory& t) {
  std::string text = fmt::format(
      "header: {{stamp: {{sec: 0, nanosec: 0}}, frame_id: \"base\"}}\njoint_names: [{}]\npoints:\n",
      joined_names(group));
  add_points(t, Keys{""}, "- ", "", text);
  return text;
}

std::string ros_trajectory_json(const JointGroup& group, const Trajectory& t) {
  std::string text = fmt::format(
      "{{\"header\": {{\"stamp\": {{\"sec\": 0, \"nanosec\": 0}}, \"frame_id\": \"base\"}},\n"
      "\"joint_names\": [{}],\n\"points\": [\n",
      joined_names(group));
  add_points(t, Keys{"\""}, "", ",", text);
  return text + "]}\n";
}

}  // namespace morphe::exports
