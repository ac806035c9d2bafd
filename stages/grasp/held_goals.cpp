#include "stages/grasp/held_goals.hpp"

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/closure_goals.hpp"

namespace morphe::grasp {
namespace {

void follow_target(const HoldInterval& hold, const SceneObject& target, std::size_t tip,
                   const Vec3& tip_in_target, Goals& goals) {
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double time_s = goals.time[f], share = closing_progress(hold, time_s);
    Vec3& goal = goals.tip_position(f, tip);
    const Vec3 held = recorded_pose(target, time_s) * tip_in_target;
    if (is_held_at(hold, time_s)) {
      goal = held;
    } else if (is_known(goal)) {
      goal = (1 - share) * goal + share * held;
    }
  }
}

}  // namespace

bool is_held_at(const HoldInterval& hold, double time_s) {
  return time_s >= hold.closed_s && time_s <= hold.opening_s;
}

void set_held_goals(const robot::Robot& robot, const std::vector<DesiredContact>& contacts,
                    const JointVector& q, std::size_t grasp_frame, const Movement& movement,
                    const SceneObject& target, Goals& goals) {
  const HoldInterval hold = hold_interval(movement);
  const std::vector<std::size_t> unrecorded = tips_without_goals(robot, goals, hold);
  goals.auto_closed.resize(robot.tips.size(), 0);
  for (const std::size_t tip : unrecorded) goals.auto_closed[tip] = 1;
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, q, base_from_frame);
  const Pose target_from_base = recorded_pose(target, goals.time[grasp_frame]).inverse();
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const bool touches = std::ranges::find(contacts, tip, &DesiredContact::tip) != contacts.end();
    if (touches || robot.tips[tip].finger < 0) continue;
    const Vec3 position = robot::tip_pose(robot, base_from_frame, tip).translation();
    follow_target(hold, target, tip, target_from_base * position, goals);
  }
}

}  // namespace morphe::grasp
