#include "stages/grasp/closure_goals.hpp"

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

void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals) {
  if (closings.empty()) return;
  const HoldInterval hold = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  std::vector<Pose> base_from_frame;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    const double share = closing_progress(hold, goals.time[f]);
    if (share == 0 || goals.time[f] > hold.opening_s) continue;
    JointVector q = path.row(f).transpose();
    for (const FingerClosure& closing : closings) q += share * closing.turn;
    robot::forward_kinematics(robot, q.cwiseMax(robot.lower).cwiseMin(robot.upper),
                              base_from_frame);
    for (const FingerClosure& closing : closings) {
      const std::size_t tip = closing.contact.tip;
      goals.tip_position(f, tip) =
          share < 1 ? robot::tracked_point(robot, base_from_frame, tip, 1)
                    : recorded_pose(target, goals.time[f]) * closing.contact.centre;
      goals.tip_to_pad_share(f, tip) = 1;
    }
  }
  goals.auto_closed.assign(robot.tips.size(), 0);
  for (const FingerClosure& closing : closings) goals.auto_closed[closing.contact.tip] = 1;
}

}  // namespace morphe::grasp
