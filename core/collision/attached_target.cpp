#include <algorithm>

#include "core/collision/continuous_check.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/motion_bounds.hpp"

namespace morphe::collision {

TargetState target_state_at(const CollisionWorld& world, double time_s) {
  const AttachedTarget& carried = world.attached;
  if (world.target < 0 || carried.frame < 0 || time_s < carried.begin_s) {
    return TargetState::as_recorded;
  }
  return time_s > carried.end_s ? TargetState::released : TargetState::attached;
}

void attach_target(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world) {
  world.attached = {};
  if (world.target < 0) return;
  const RobotModel& robot = *world.robot;
  const SceneObject& target = world.scene->objects[world.target];
  const auto frame =
      std::ranges::find(robot.frames, target.attached_frame, &RobotModel::Frame::name);
  const auto first_from = [&](double time_s) {
    return std::ranges::lower_bound(demonstration_time, time_s);
  };
  if (frame == robot.frames.end() || std::isnan(target.attach_s)) return;
  const auto taken = first_from(target.attach_s);
  if (taken == demonstration_time.end() || *taken >= demonstration_time.back()) return;

  AttachedTarget& carried = world.attached;
  carried.frame = static_cast<int>(frame - robot.frames.begin());
  carried.begin_s = *taken;
  std::vector<Pose> base_from_frame;
  const auto frame_at = [&](auto sample) -> const Pose& {
    const JointVector q = position.row(sample - demonstration_time.begin());
    robot::forward_kinematics(robot, q, base_from_frame);
    return base_from_frame[carried.frame];
  };
  carried.frame_from_object = frame_at(taken).inverse() * recorded_pose(target, *taken);
  carried.motion_bounds =
      robot::sphere_motion_bounds(robot, carried.frame, carried.frame_from_object.translation(),
                                  bounding_radius(solid_at(world, world.target)));
  if (std::isnan(target.release_s)) return;
  const auto released = first_from(target.release_s);
  if (released == demonstration_time.end()) return;
  carried.end_s = *released;
  carried.base_from_released = frame_at(released) * carried.frame_from_object;
}

}  // namespace morphe::collision
