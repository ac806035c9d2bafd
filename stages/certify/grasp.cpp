#include "stages/certify/grasp.hpp"

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::certify {
namespace {

int tip_of_finger(const RobotModel& robot, int finger) {
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    if (robot.tips[tip].finger == finger) return tip;
  }
  return -1;
}

JointVector posture_at(const Trajectory& trajectory, int sample) {
  return trajectory.position.row(sample).transpose();
}

JointVector widest_posture(const RobotModel& robot, const Trajectory& trajectory,
                           int grasp_sample) {
  const int thumb = tip_of_finger(robot, 0), index = tip_of_finger(robot, 1);
  int widest_sample = 0;
  double max_opening_m = -1;
  std::vector<Pose> base_from_frame;
  for (int i = 0; thumb >= 0 && index >= 0 && i <= grasp_sample; ++i) {
    robot::forward_kinematics(robot, posture_at(trajectory, i), base_from_frame);
    const auto position = [&](int tip) -> Vec3 {
      return robot::tip_pose(robot, base_from_frame, tip).translation();
    };
    const double opening_m = (position(thumb) - position(index)).norm();
    if (opening_m <= max_opening_m) continue;
    max_opening_m = opening_m;
    widest_sample = i;
  }
  return posture_at(trajectory, widest_sample);
}

/// Returns the direction, in the base frame, to the palm at `sample` from the last earlier one at
/// which it was kApproachLength_m or farther away; an unseen point without such a sample.
Vec3 approach_direction(const RobotModel& robot, const Trajectory& trajectory, int sample) {
  std::vector<Pose> base_from_frame;
  const auto palm_at = [&](int i) -> Vec3 {
    robot::forward_kinematics(robot, posture_at(trajectory, i), base_from_frame);
    return base_from_frame[robot.palm_frame].translation();
  };
  const Vec3 palm = palm_at(sample);
  for (int i = sample - 1; i >= 0; --i) {
    const Vec3 approach = palm - palm_at(i);
    if (approach.norm() >= kApproachLength_m) return approach.normalized();
  }
  return unknown_point();
}

}  // namespace

Grasp find_grasp(const RobotModel& robot, const Scene& scene, const Movement& movement,
                 const Trajectory& trajectory) {
  Grasp grasp;
  const SceneObject* target = find_object(scene.objects, movement.target);
  const auto phase = std::ranges::find(movement.phases, PhaseKind::grasp, &Phase::kind);
  if (!target || phase == movement.phases.end() || trajectory.samples() == 0) return grasp;
  const auto& times = trajectory.demonstration_time;
  const auto first = std::ranges::lower_bound(times, phase->begin_s);
  const int sample = static_cast<int>(std::min(first - times.begin(), std::ssize(times) - 1));
  grasp.sample = sample;
  grasp.grasp_posture = posture_at(trajectory, sample);
  grasp.pregrasp_posture = widest_posture(robot, trajectory, sample);
  grasp.base_from_object = recorded_pose(*target, times[sample]);
  const Pose object_from_base = grasp.base_from_object.inverse();
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, grasp.grasp_posture, base_from_frame);
  grasp.object_from_palm = object_from_base * base_from_frame[robot.palm_frame];
  grasp.approach_direction =
      object_from_base.linear() * approach_direction(robot, trajectory, sample);
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    grasp.tips_in_object.push_back(object_from_base *
                                   robot::tip_pose(robot, base_from_frame, tip).translation());
  }
  return grasp;
}

}  // namespace morphe::certify
