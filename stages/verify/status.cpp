#include "stages/verify/status.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stages/verify/goal_errors.hpp"
#include "stages/verify/missing_goals.hpp"

namespace morphe::verify {
namespace {

double unreachable_share(const Goals& goals) {
  double count = 0, unreachable = 0;
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
    if (!goals.auto_closed.empty() && goals.auto_closed[tip] != 0) continue;
    for (std::size_t f = 0; f < goals.tip_position.rows; ++f) {
      if (!is_known(goals.tip_position(f, tip))) continue;
      count += 1;
      unreachable += goals.reachable(f, tip) == 0 ? 1 : 0;
    }
  }
  return count > 0 ? unreachable / count : 0;
}

}  // namespace

void verify_status(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  const Tolerances& allowed = plan.tolerances;
  if (std::isnan(allowed.max_unreachable_share) && std::isnan(allowed.max_tip_error)) return;
  const double share = unreachable_share(plan.goals);
  const GoalGaps gaps = find_goal_gaps(plan);
  const double tip_error = goal_errors(robot, plan).position_max;
  struct Excess {
    const char* name;
    double value, limit;
    bool exceeds;
  };
  const auto compare = [](const char* name, double value, double limit) {
    return Excess{name, value, limit, value > limit};
  };
  std::array kinds{
      compare("max_unreachable_share", share, allowed.max_unreachable_share),
      compare("max_tip_error", tip_error, allowed.max_tip_error),
      compare("max_missing_goal_share", gaps.largest_share, allowed.max_missing_goal_share),
      compare("max_goal_gap_s", gaps.longest_s, allowed.max_goal_gap_s)};
  kinds[0].exceeds = kinds[0].exceeds || share == 1;
  if (plan.approximate) {
    if (std::ranges::none_of(kinds, &Excess::exceeds))
      violations.note_plan("status", "approximate", share, allowed.max_unreachable_share);
    return;
  }
  for (const Excess& kind : kinds)
    if (kind.exceeds) violations.note_plan("status", kind.name, kind.value, kind.limit);
}

}  // namespace morphe::verify
