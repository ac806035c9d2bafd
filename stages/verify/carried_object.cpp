#include "stages/verify/carried_object.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/find_index.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

/// Measures the carried object at samples of the trajectory.
struct SampleDistances {
  const RobotModel& robot;
  const Plan& plan;
  const Trajectory& trajectory;
  const AttachedObject& attached;
  const std::vector<Mesh>& meshes;
  int object;

  double operator()(int other, std::ptrdiff_t sample) const {
    const double time_s = trajectory.demonstration_time[sample];
    const std::vector<SceneObject>& objects = plan.scene.objects;
    const Pose own = carried_pose(robot, objects[object], attached,
                                  trajectory.position.row(sample).transpose(), time_s);
    const Pose base_from_other = recorded_pose(objects[other], time_s);
    return body_distance({objects[object], meshes[object], own},
                         {objects[other], meshes[other], base_from_other}, kMaxReleaseHeight_m);
  }
};

CarriedObject::Contact allowed_contact(const SampleDistances& distance, int other,
                                       std::ptrdiff_t taken, std::ptrdiff_t released) {
  const std::vector<double>& time = distance.trajectory.demonstration_time;
  const double clear = std::max(kSupportNoise_m, distance.plan.tolerances.required_clearance);
  CarriedObject::Contact contact;
  if (distance(other, taken) <= kSupportNoise_m) {
    contact.until_s = kInfinity;
    for (std::ptrdiff_t sample = taken; sample <= released; ++sample) {
      if (!(distance(other, sample) >= clear)) continue;
      contact.until_s = time[sample];
      break;
    }
  }
  if (distance(other, released) <= kSupportNoise_m) {
    contact.from_s = -kInfinity;
    for (std::ptrdiff_t sample = released; sample >= taken; --sample) {
      if (!(distance(other, sample) >= clear)) continue;
      contact.from_s = time[sample];
      break;
    }
  }
  return contact;
}

}  // namespace

Pose carried_pose(const RobotModel& robot, const SceneObject& object,
                  const AttachedObject& attached, const JointVector& q, double time_s) {
  if (attached.is_released(time_s)) return attached.base_from_released_object;
  if (!attached.is_attached(time_s)) return recorded_pose(object, time_s);
  std::vector<Pose> base_from_frame;
  frame_poses(robot, q, base_from_frame);
  return base_from_frame[attached.frame] * attached.frame_from_object;
}

CarriedObject find_carried_object(const RobotModel& robot, const Plan& plan,
                                  const Trajectory& trajectory, const AttachedObject& attached,
                                  const std::vector<Mesh>& meshes) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  const std::vector<double>& time = trajectory.demonstration_time;
  CarriedObject carried;
  const int object = find_index(objects, plan.movement.target, &SceneObject::name);
  if (plan.movement.target.empty() || object < 0 || !has_valid_shape(objects[object])) return {};
  const SceneObject& target = objects[object];
  if (std::isnan(target.attach_s) || !(time.back() > target.attach_s)) return {};
  const auto taken = std::ranges::lower_bound(time, target.attach_s) - time.begin();
  if (time[taken] >= time.back()) return {};
  const auto released =
      std::isnan(target.release_s)
          ? std::ssize(time) - 1
          : std::min(std::ranges::lower_bound(time, target.release_s) - time.begin(),
                     std::ssize(time) - 1);
  carried.object = object;
  carried.begin_s = time[taken];
  carried.contacts.resize(objects.size());
  const SampleDistances distance{robot, plan, trajectory, attached, meshes, object};
  for (int other = 0; other < std::ssize(objects); ++other) {
    if (other == object || !has_valid_shape(objects[other])) continue;
    carried.contacts[other] = allowed_contact(distance, other, taken, released);
    carried.stood = carried.stood || carried.contacts[other].until_s > -kInfinity;
    carried.release_height = std::min(carried.release_height, distance(other, released));
  }
  if (target.release_s <= time.back()) carried.release_s = time[released];
  return carried;
}

}  // namespace morphe::verify
