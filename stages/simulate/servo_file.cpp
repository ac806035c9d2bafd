#include "stages/simulate/servo_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/config/fields.hpp"

namespace morphe::simulate {

std::string validation_error(const ServoGains& o) {
  const auto is_invalid = [](const std::optional<double>& value, bool may_be_zero) {
    return value && !(std::isfinite(*value) && (*value > 0 || (may_be_zero && *value == 0)));
  };
  if (is_invalid(o.stiffness, false)) return "stiffness must be above 0";
  if (is_invalid(o.velocity_gain, true)) return "velocity_gain must not be negative";
  if (is_invalid(o.armature, true)) return "armature must not be negative";
  if (is_invalid(o.damping, true)) return "damping must not be negative";
  if (is_invalid(o.torque_limit, false)) return "torque_limit must be above 0";
  return "";
}

ServoTable read_servos(const std::filesystem::path& file, const RobotModel& robot) {
  const config::ConfigNode root = config::ConfigNode::load(file);
  root.expect_map();
  ServoTable table;
  config::ErrorList problems;
  for (const std::string& joint : root.keys()) {
    problems.attempt([&] {
      const config::ConfigNode node = root[joint];
      if (std::ranges::count(robot.joint_names, joint) == 0)
        node.fail(fmt::format("is not a joint of {}; its joints are {}", robot.name,
                              fmt::join(robot.joint_names, ", ")));
      config::read_options(node, table[joint]);
    });
  }
  if (problems.none()) root.report_unread_keys(problems);
  problems.throw_if_any();
  return table;
}

std::string text_of(const ServoTable& table) {
  std::string text;
  for (const auto& [joint, gains] : table) {
    text += fmt::format("servo {}", joint);
    ServoGains copy = gains;
    const auto add = [&](const char* key, const std::optional<double>& value) {
      if (value) text += fmt::format(" {} {}", key, *value);
    };
    fields(add, copy);
    text += "\n";
  }
  return text;
}

}  // namespace morphe::simulate
