#include "pipeline/commands/plan_table_footer.hpp"

#include <fmt/format.h>

namespace morphe::commands {

std::string plan_table_footer(const RobotModel& robot, const run::BatchSummary& summary) {
  std::string text =
      fmt::format("{}: {} of {} fingertip goals are out of reach with this placement", robot.name,
                  summary.out_of_reach, summary.goals);
  const std::string unchecked = unchecked_sentence(robot.unchecked_links);
  if (!unchecked.empty()) text += fmt::format("\n{}: {}", robot.name, unchecked);
  return text;
}

}  // namespace morphe::commands
