#include "stages/grasp/closure_goals.hpp"

#include <algorithm>
#include <iterator>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::grasp {

std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& hold) {
  std::vector<std::size_t> tips;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    if (robot.tips[tip].finger < 0 || robot.pads[tip].capsule < 0) continue;
    bool has_goal = false;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      const bool held = goals.time[f] >= hold.begin_s && goals.time[f] <= hold.end_s;
      has_goal = has_goal || (held && is_known(goals.tip_position(f, tip)));
    }
    if (!has_goal) tips.push_back(tip);
  }
  return tips;
}

void set_closure_goals(const robot::Robot& robot, const std::vector<DesiredContact>& contacts,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals) {
  std::vector<DesiredContact> closed;
  std::ranges::copy_if(contacts, std::back_inserter(closed), [](const DesiredContact& contact) {
    return contact.origin == ContactOrigin::auto_closed;
  });
  if (closed.empty()) return;
  const HoldInterval hold = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  std::vector<Pose> base_from_frame;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    const double share = closing_progress(hold, goals.time[f]);
    if (share == 0 || goals.time[f] > hold.opening_s) continue;
    const JointVector q = path.row(f).transpose();
    robot::forward_kinematics(robot, q.cwiseMax(robot.lower).cwiseMin(robot.upper),
                              base_from_frame);
    for (const DesiredContact& contact : closed) {
      goals.tip_position(f, contact.tip) =
          share < 1 ? robot::tracked_point(robot, base_from_frame, contact.tip, 1)
                    : recorded_pose(target, goals.time[f]) * contact.centre;
      goals.tip_to_pad_share(f, contact.tip) = 1;
    }
  }
  goals.auto_closed.assign(robot.tips.size(), 0);
  for (const DesiredContact& contact : closed) goals.auto_closed[contact.tip] = 1;
}

}  // namespace morphe::grasp
