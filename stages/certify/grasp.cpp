#include "stages/certify/grasp.hpp"

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::certify {
namespace {

int tip_of_finger(const RobotModel& robot, int finger) {
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.tips[tip].finger == finger) return static_cast<int>(tip);
  }
  return -1;
}

JointVector posture_at(const Trajectory& trajectory, std::size_t sample) {
  return trajectory.position.row(sample).transpose();
}

JointVector widest_posture(const RobotModel& robot, const Trajectory& trajectory,
                           std::size_t grasp_sample) {
  const int thumb = tip_of_finger(robot, 0), index = tip_of_finger(robot, 1);
  std::size_t widest = 0;
  double most_m = -1;
  std::vector<Pose> base_from_frame;
  for (std::size_t i = 0; thumb >= 0 && index >= 0 && i <= grasp_sample; ++i) {
    robot::forward_kinematics(robot, posture_at(trajectory, i), base_from_frame);
    const auto place = [&](int tip) -> Vec3 {
      return robot::tip_pose(robot, base_from_frame, tip).translation();
    };
    const double opening_m = (place(thumb) - place(index)).norm();
    if (opening_m <= most_m) continue;
    most_m = opening_m;
    widest = i;
  }
  return posture_at(trajectory, widest);
}

/// Returns the direction of the palm's motion from the last sample that is kApproachLength_m away
/// from the grasp's, in the base frame.
Vec3 approach_direction(const RobotModel& robot, const Trajectory& trajectory, std::size_t sample) {
  std::vector<Pose> base_from_frame;
  const auto palm_at = [&](std::size_t i) -> Vec3 {
    robot::forward_kinematics(robot, posture_at(trajectory, i), base_from_frame);
    return base_from_frame[robot.palm_frame].translation();
  };
  const Vec3 there = palm_at(sample);
  for (std::size_t i = sample; i-- > 0;) {
    const Vec3 way = there - palm_at(i);
    if (way.norm() >= kApproachLength_m) return way.normalized();
  }
  return unknown_point();
}

}  // namespace

Grasp find_grasp(const RobotModel& robot, const Scene& scene, const Movement& movement,
                 const Trajectory& trajectory) {
  Grasp grasp;
  const SceneObject* target = find_object(scene.objects, movement.target);
  const auto phase = std::find_if(movement.phases.begin(), movement.phases.end(),
                                  [](const Phase& p) { return p.kind == PhaseKind::grasp; });
  if (!target || phase == movement.phases.end() || trajectory.samples() == 0) return grasp;
  const auto& times = trajectory.demonstration_time;
  const auto found = std::lower_bound(times.begin(), times.end(), phase->begin_s);
  const std::size_t sample =
      std::min(static_cast<std::size_t>(found - times.begin()), times.size() - 1);
  grasp.sample = static_cast<int>(sample);
  grasp.grasp_posture = posture_at(trajectory, sample);
  grasp.pregrasp_posture = widest_posture(robot, trajectory, sample);
  grasp.base_from_object = recorded_pose(*target, times[sample]);
  const Pose object_from_base = grasp.base_from_object.inverse();
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, grasp.grasp_posture, base_from_frame);
  grasp.object_from_palm = object_from_base * base_from_frame[robot.palm_frame];
  grasp.approach_direction =
      object_from_base.linear() * approach_direction(robot, trajectory, sample);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    grasp.tips_in_object.push_back(object_from_base *
                                   robot::tip_pose(robot, base_from_frame, tip).translation());
  }
  return grasp;
}

}  // namespace morphe::certify
