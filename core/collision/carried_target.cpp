#include "core/collision/carried_target.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/constants.hpp"
#include "core/collision/world.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::collision {
namespace {

/// The samples of a path in which the target is carried, and its distances from other objects.
struct CarriedSamples {
  const CollisionWorld& world;
  const std::vector<double>& time;
  const JointRows& position;
  std::ptrdiff_t first, last;
  std::vector<Pose> base_from_frame;

  Pose base_from_target(std::ptrdiff_t sample) {
    const AttachedTarget& attached = world.attached;
    if (attached.frame < 0) return recorded_pose(world.scene->objects[world.target], time[sample]);
    const JointVector q = position.row(sample);
    robot::forward_kinematics(*world.robot, q, base_from_frame);
    return base_from_frame[attached.frame] * attached.frame_from_object;
  }

  /// Returns the distance from an object; from `enough_m` on, a lower bound of it [m].
  double distance(int object, std::ptrdiff_t sample, double enough_m) {
    const Solid target = solid_at(world, world.target), other = solid_at(world, object);
    const Pose target_pose = base_from_target(sample);
    const Pose other_pose = recorded_pose(other.object, time[sample]);
    const double bound_m = solid_distance_lower_bound(target, target_pose, other, other_pose);
    return bound_m >= enough_m ? bound_m
                               : solid_solid(target, target_pose, other, other_pose).distance;
  }
};

/// Returns the contact with an object that is allowed, for no time if it supports the target never.
SupportContact support_contact(int object, CarriedSamples& samples) {
  SupportContact contact{object};
  const double clear_m = std::max(samples.world.tolerances.required_clearance, kSupportNoise_m);
  const auto is_clear = [&](std::ptrdiff_t sample) {
    return samples.distance(object, sample, clear_m) >= clear_m;
  };
  if (samples.distance(object, samples.first, clear_m) <= kSupportNoise_m) {
    std::ptrdiff_t sample = samples.first;
    while (sample <= samples.last && !is_clear(sample)) ++sample;
    contact.lifted_s = sample <= samples.last ? samples.time[sample] : kInfinity;
  }
  if (samples.distance(object, samples.last, clear_m) <= kSupportNoise_m) {
    std::ptrdiff_t sample = samples.last;
    while (sample >= samples.first && !is_clear(sample)) --sample;
    contact.lowered_s = sample >= samples.first ? samples.time[sample] : -kInfinity;
  }
  return contact;
}

}  // namespace

void find_supports(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world) {
  world.carried = {};
  if (world.target < 0) return;
  const SceneObject& target = world.scene->objects[world.target];
  if (std::isnan(target.attach_s)) return;
  const auto sample_at = [&](double time_s) {
    return std::ranges::lower_bound(demonstration_time, time_s) - demonstration_time.begin();
  };
  const std::ptrdiff_t last = std::ssize(demonstration_time) - 1;
  const std::ptrdiff_t taken = sample_at(target.attach_s);
  if (taken > last || demonstration_time[taken] >= demonstration_time[last]) return;
  const std::ptrdiff_t released =
      std::isnan(target.release_s) ? last : std::min(last, sample_at(target.release_s));
  CarriedSamples samples{world, demonstration_time, position, taken, released, {}};
  CarriedTarget carried{demonstration_time[taken], {}};
  double release_gap_m = kInfinity;
  bool stood = false;
  for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
    if (k == world.target) continue;
    const SupportContact contact = support_contact(k, samples);
    stood = stood || contact.lifted_s > -kInfinity;
    release_gap_m = std::min(release_gap_m, samples.distance(k, released, kMaxReleaseGap_m));
    if (contact.lifted_s > -kInfinity || contact.lowered_s < kInfinity)
      carried.supports.push_back(contact);
  }
  const bool is_released = target.release_s <= demonstration_time[last];
  if (stood && is_released) carried.release_gap_m = std::max(0.0, release_gap_m);
  world.carried = std::move(carried);
}

bool is_carried(const CollisionWorld& world, double time_s) {
  return world.target >= 0 && time_s >= world.carried.begin_s;
}

double carried_required_distance_m(const CollisionWorld& world, int object, double time_s) {
  return carried_may_touch(world, object, time_s) ? -kSupportNoise_m
                                                  : world.tolerances.required_clearance;
}

bool carried_may_touch(const CollisionWorld& world, int object, double time_s) {
  const auto contact = std::ranges::find(world.carried.supports, object, &SupportContact::object);
  return contact != world.carried.supports.end() && contact->is_allowed(time_s);
}

}  // namespace morphe::collision
