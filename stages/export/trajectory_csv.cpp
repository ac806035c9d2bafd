#include "stages/export/trajectory_csv.hpp"

#include <fmt/format.h>

#include <iterator>

namespace morphe::exports {
namespace {

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string trajectory_csv(const RobotTable& robot, const Trajectory& t) {
  std::string text = "time_s,demonstration_time_s,phase";
  for (const char* what : {"position_rad", "velocity_rad_s", "acceleration_rad_s2"}) {
    for (const std::string& joint : robot.joint_names) text += "," + cell(joint + "_" + what);
  }
  text += "\n";
  for (std::size_t i = 0; i < t.samples(); ++i) {
    fmt::format_to(std::back_inserter(text), "{:.17g},{:.17g},{}", t.time[i],
                   t.demonstration_time[i], name_of(t.phase[i]));
    for (const JointRows* rows : {&t.position, &t.velocity, &t.acceleration}) {
      for (const double value : rows->row(static_cast<Eigen::Index>(i))) {
        fmt::format_to(std::back_inserter(text), ",{:.17g}", value);
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace morphe::exports
