#include <algorithm>

#include "core/collision/world.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/motion_bounds.hpp"

namespace morphe::collision {

TargetState target_state_at(const CollisionWorld& world, double time_s) {
  const AttachedTarget& attached = world.attached;
  if (world.target < 0 || attached.frame < 0 || time_s < attached.begin_s)
    return TargetState::as_recorded;
  return time_s > attached.end_s ? TargetState::released : TargetState::attached;
}

namespace {

void attach_to_frame(const std::vector<double>& demonstration_time, const JointRows& position,
                     CollisionWorld& world) {
  world.attached = {};
  if (world.target < 0) return;
  const RobotModel& robot = *world.robot;
  const SceneObject& target = world.scene->objects[world.target];
  const auto frame =
      std::ranges::find(robot.frames, target.attached_frame, &RobotModel::Frame::name);
  if (frame == robot.frames.end() || std::isnan(target.attach_s)) return;
  const auto attach_sample = std::ranges::lower_bound(demonstration_time, target.attach_s);
  if (attach_sample == demonstration_time.end() || *attach_sample >= demonstration_time.back())
    return;

  AttachedTarget& attached = world.attached;
  attached.frame = static_cast<int>(frame - robot.frames.begin());
  attached.begin_s = *attach_sample;
  std::vector<Pose> base_from_frame;
  const auto frame_at = [&](auto sample) -> const Pose& {
    const JointVector q = position.row(sample - demonstration_time.begin());
    robot::forward_kinematics(robot, q, base_from_frame);
    return base_from_frame[attached.frame];
  };
  attached.frame_from_object =
      frame_at(attach_sample).inverse() * recorded_pose(target, *attach_sample);
  attached.motion_bounds =
      robot::sphere_motion_bounds(robot, attached.frame, attached.frame_from_object.translation(),
                                  bounding_radius(solid_at(world, world.target)));
  if (std::isnan(target.release_s)) return;
  const auto release_sample = std::ranges::lower_bound(demonstration_time, target.release_s);
  if (release_sample == demonstration_time.end()) return;
  attached.end_s = *release_sample;
  attached.base_from_released = frame_at(release_sample) * attached.frame_from_object;
}

}  // namespace

void attach_target(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world) {
  attach_to_frame(demonstration_time, position, world);
  find_supports(demonstration_time, position, world);
}

}  // namespace morphe::collision
