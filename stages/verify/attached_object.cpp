#include "stages/verify/attached_object.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {

AttachedObject find_attached_object(const RobotModel& robot, const Plan& plan,
                                    const Trajectory& trajectory) {
  const auto& objects = plan.scene.objects;
  const auto target = std::ranges::find(objects, plan.movement.target, &SceneObject::name);
  if (target == objects.end() || std::isnan(target->attach_s)) return {};
  const auto frame =
      std::ranges::find(robot.frames, target->attached_frame, &RobotModel::Frame::name);
  const std::vector<double>& time = trajectory.demonstration_time;
  const auto taken = std::ranges::lower_bound(time, target->attach_s);
  if (frame == robot.frames.end() || taken == time.end() || *taken >= time.back()) return {};

  AttachedObject carried;
  carried.object = static_cast<int>(target - objects.begin());
  carried.frame = static_cast<int>(frame - robot.frames.begin());
  carried.attach_s = *taken;
  carried.release_s = std::numeric_limits<double>::infinity();
  std::vector<Pose> base_from_frame;
  const auto hand_at = [&](auto sample) -> const Pose& {
    frame_poses(robot, trajectory.position.row(sample - time.begin()).transpose(), base_from_frame);
    return base_from_frame[carried.frame];
  };
  carried.frame_from_object = hand_at(taken).inverse() * recorded_pose(*target, *taken);
  const auto released = std::isnan(target->release_s)
                            ? time.end()
                            : std::ranges::lower_bound(time, target->release_s);
  if (released == time.end()) return carried;
  carried.release_s = *released;
  carried.base_from_released_object = hand_at(released) * carried.frame_from_object;
  return carried;
}

}  // namespace morphe::verify
