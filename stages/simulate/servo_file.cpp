#include "stages/simulate/servo_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/config/fields.hpp"

namespace morphe::simulate {

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
    const auto add = [&](const char* key, const std::optional<double>& value, const KeyBounds&) {
      if (value) text += fmt::format(" {} {}", key, *value);
    };
    fields(add, copy);
    text += "\n";
  }
  return text;
}

}  // namespace morphe::simulate
