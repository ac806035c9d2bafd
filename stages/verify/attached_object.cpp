#include "stages/verify/attached_object.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {

AttachedObject find_attached_object(const RobotModel& robot, const Plan& plan,
                                    const Trajectory& trajectory) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  AttachedObject attached;
  attached.object = find_index(objects, plan.movement.target, &SceneObject::name);
  if (attached.object < 0 || std::isnan(objects[attached.object].attach_s)) return {};
  const SceneObject& target = objects[attached.object];
  attached.frame = find_index(robot.frames, target.attached_frame, &RobotModel::Frame::name);
  const std::vector<double>& time = trajectory.demonstration_time;
  const auto attach = std::ranges::lower_bound(time, target.attach_s);
  if (attached.frame < 0 || attach == time.end() || *attach >= time.back()) return {};

  std::vector<Pose> base_from_frame;
  const auto base_from_hand = [&](auto sample) -> const Pose& {
    frame_poses(robot, trajectory.position.row(sample - time.begin()).transpose(), base_from_frame);
    return base_from_frame[attached.frame];
  };
  attached.attach_s = *attach;
  attached.release_s = kInfinity;
  attached.frame_from_object = base_from_hand(attach).inverse() * recorded_pose(target, *attach);
  if (std::isnan(target.release_s)) return attached;
  const auto release = std::ranges::lower_bound(time, target.release_s);
  if (release == time.end()) return attached;
  attached.release_s = *release;
  attached.base_from_released_object = base_from_hand(release) * attached.frame_from_object;
  return attached;
}

}  // namespace morphe::verify
