#include "stages/verify/status.hpp"

#include <cmath>

#include "stages/verify/goal_errors.hpp"

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
  const double max_share = plan.tolerances.max_unreachable_share;
  const double max_tip_error = plan.tolerances.max_tip_error;
  if (std::isnan(max_share) && std::isnan(max_tip_error)) return;
  const double share = unreachable_share(plan.goals);
  const double tip_error = goal_errors(robot, plan).position_max;
  const bool out_of_reach = share > max_share || share == 1, too_far = tip_error > max_tip_error;
  if (plan.approximate) {
    if (!out_of_reach && !too_far) violations.note_plan("status", "approximate", share, max_share);
    return;
  }
  if (out_of_reach) violations.note_plan("status", "max_unreachable_share", share, max_share);
  if (too_far) violations.note_plan("status", "max_tip_error", tip_error, max_tip_error);
}

}  // namespace morphe::verify
