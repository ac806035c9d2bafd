#include "stages/verify/status.hpp"

#include <cmath>

#include "stages/verify/goal_errors.hpp"

namespace morphe::verify {
namespace {

double unreachable_share(const Goals& goals) {
  double asked = 0, out = 0;
  for (std::size_t f = 0; f < goals.tip_position.rows; ++f) {
    for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
      if (!goals.tip_position(f, tip).allFinite()) continue;
      if (!goals.auto_closed.empty() && goals.auto_closed[tip] != 0) continue;
      asked += 1;
      out += goals.reachable(f, tip) == 0 ? 1 : 0;
    }
  }
  return asked > 0 ? out / asked : 0;
}

}  // namespace

void verify_status(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const double most = plan.tolerances.max_unreachable_share,
               farthest = plan.tolerances.max_tip_error;
  if (std::isnan(most) && std::isnan(farthest)) return;
  const double share = unreachable_share(plan.goals);
  const double tip = goal_errors(robot, plan).position_max;
  const bool out_of_reach = share > most || share == 1, far = tip > farthest;
  if (plan.approximate) {
    if (!out_of_reach && !far) runs.note_plan("status", "approximate", share, most);
    return;
  }
  if (out_of_reach) runs.note_plan("status", "max_unreachable_share", share, most);
  if (far) runs.note_plan("status", "max_tip_error", tip, farthest);
}

}  // namespace morphe::verify
