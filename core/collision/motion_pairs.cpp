#include "core/collision/motion_pairs.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace morphe::collision {

PairSeparation MotionPairs::pair_of(std::size_t number) const {
  PairSeparation pair;
  pair.required_distance_m = world.tolerances.required_clearance;
  if (number < world.pairs.size()) {
    pair.capsule = world.pairs[number][0];
    pair.other = world.pairs[number][1];
    return pair;
  }
  const std::size_t k = number - world.pairs.size();
  pair.other_is_object = true;
  pair.capsule = static_cast<int>(k / objects());
  pair.other = static_cast<int>(k % objects());
  if (may_touch(pair)) pair.required_distance_m = -allowed_contact_depth_m(world, pair.capsule);
  return pair;
}

void MotionPairs::set_interval(double s0, double middle, double s1) {
  motion.position(middle, scratch.position);
  motion.travel(s0, s1, scratch.travel);
  const double middle_s = motion.demonstration_time(middle);
  update_bodies(world, scratch.position, middle_s, scratch);
  for (std::size_t c = 0; c < scratch.bodies.size(); ++c) {
    scratch.body_travel[c] = world.robot->capsule_motion_bounds.row(c).dot(scratch.travel);
  }
  for (std::size_t k = 0; k < objects(); ++k) {
    const SceneObject& object = world.scene->objects[k];
    const bool still = object.time.size() < 2 || (static_cast<int>(k) == world.target &&
                                                  target_state != TargetState::as_recorded);
    scratch.object_travel[k] =
        still ? 0
              : object_travel(solid_at(world, k), motion.demonstration_time(s0), middle_s,
                              motion.demonstration_time(s1));
  }
}

/// Returns a bound on the relative travel of two bodies. Joints above a common parent move both
/// bodies alike and do not change their distance. `levers_a`, `levers_b`: [joints] of each body.
double MotionPairs::relative_travel(int a, const double* levers_a, int b,
                                    const double* levers_b) const {
  int last_a = -1, last_b = -1;  // a coupled joint moves adjacent frames; it is counted once
  double sum_m = 0;
  while (a != b) {
    // Parents come first, so the later frame is not an ancestor of the other.
    const bool first = a > b;
    int& frame = first ? a : b;
    int& last = first ? last_a : last_b;
    const RobotModel::Frame& turned = world.robot->frames[frame];
    if (turned.joint >= 0 && turned.joint != last) {
      sum_m += (first ? levers_a : levers_b)[turned.joint] * scratch.travel[turned.joint];
      last = turned.joint;
    }
    frame = turned.parent;
  }
  return sum_m;
}

double MotionPairs::pair_travel(const PairSeparation& pair) const {
  const auto first = static_cast<std::size_t>(pair.capsule);
  const auto other = static_cast<std::size_t>(pair.other);
  const int frame = world.robot->capsules[first].frame;
  const double* own = world.robot->capsule_motion_bounds.row(pair.capsule).data();
  if (!pair.other_is_object) {
    return relative_travel(frame, own, world.robot->capsules[other].frame,
                           world.robot->capsule_motion_bounds.row(pair.other).data());
  }
  if (pair.other == world.target && target_state == TargetState::attached) {
    return relative_travel(frame, own, world.attached.frame, world.attached.motion_bounds.data());
  }
  return scratch.body_travel[first] + scratch.object_travel[other];
}

double MotionPairs::slack_lower_bound(const PairSeparation& pair) const {
  const CollisionScratch::BoundingSphere& a = scratch.bounding_spheres[pair.capsule];
  const double around = a.radius + pair.required_distance_m;
  const auto other = static_cast<std::size_t>(pair.other);
  if (!pair.other_is_object) {
    const CollisionScratch::BoundingSphere& b = scratch.bounding_spheres[other];
    return (a.centre - b.centre).norm() - b.radius - around;
  }
  const Pose& pose = scratch.object_poses[other];
  const Vec3 in_object = pose.linear().transpose() * (a.centre - pose.translation());
  return signed_distance_lower_bound(solid_at(world, other), in_object) - around;
}

void MotionPairs::measure(PairSeparation& pair) const {
  const CapsuleBody& first = scratch.bodies[pair.capsule];
  const auto other = static_cast<std::size_t>(pair.other);
  pair.separation = pair.other_is_object
                        ? capsule_solid(first, solid_at(world, other), scratch.object_poses[other])
                        : capsule_capsule(first, scratch.bodies[other]);
}

/// Returns the parameter at which the demonstration time reaches `time_s`, by bisection.
double MotionPairs::parameter_at_time(double time_s) const {
  double low = motion.begin, high = motion.end;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (motion.demonstration_time(middle) < time_s ? low : high) = middle;
  }
  return high;
}

bool MotionPairs::may_touch(const PairSeparation& pair) const {
  return contact_allowed && pair.other_is_object && pair.other == world.target &&
         world.robot->capsules[pair.capsule].may_touch_target;
}

void MotionPairs::for_each_part(const std::function<bool(double, double)>& part) {
  const std::size_t pairs = world.pairs.size() + world.robot->capsules.size() * objects();
  scratch.undecided_pairs.resize(kMaxBisectionDepth + 1);
  scratch.body_travel.resize(world.robot->capsules.size());
  scratch.object_travel.resize(objects());
  const double begin_s = motion.demonstration_time(motion.begin);
  const double end_s = motion.demonstration_time(motion.end);
  std::array<double, 4> borders{world.touch_begin_s, world.touch_end_s, world.attached.begin_s,
                                world.attached.end_s};
  for (double& border_s : borders) {
    const bool inside = begin_s < border_s && border_s < end_s;
    border_s = inside ? parameter_at_time(border_s) : motion.end;  // for NaN too
  }
  std::ranges::sort(borders);
  double from = motion.begin;
  for (const double border : borders) {
    if (border > from) {
      scratch.undecided_pairs[0].resize(pairs);
      std::iota(scratch.undecided_pairs[0].begin(), scratch.undecided_pairs[0].end(),
                std::size_t{0});
      const double middle_s = motion.demonstration_time(0.5 * (from + border));
      contact_allowed = middle_s >= world.touch_begin_s && middle_s <= world.touch_end_s;
      target_state = target_state_at(world, middle_s);
      if (!part(from, border)) return;
      from = border;
    }
  }
}

}  // namespace morphe::collision
