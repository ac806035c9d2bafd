#include "stages/repair/interval_world.hpp"

#include <algorithm>

namespace morphe {
namespace {

constexpr int kTimes = 5;  ///< at which moving objects are looked at

bool moves(const SceneObject& object, double begin_s, double end_s) {
  return object.time.size() > 1 && object.time.front() < end_s && object.time.back() > begin_s &&
         !(recorded_pose(object, begin_s).isApprox(recorded_pose(object, end_s), 1e-9) &&
           recorded_pose(object, begin_s)
               .isApprox(recorded_pose(object, (begin_s + end_s) / 2), 1e-9));
}

void apply(TouchRule rule, double begin_s, double end_s, CollisionWorld& world) {
  const bool always = begin_s >= world.touch_begin_s && end_s <= world.touch_end_s;
  const bool sometimes = begin_s <= world.touch_end_s && end_s >= world.touch_begin_s;
  if (always || !sometimes) return;
  world.touch_begin_s = rule == TouchRule::strict ? kNotSeen : begin_s;
  world.touch_end_s = rule == TouchRule::strict ? kNotSeen : end_s;
}

}  // namespace

CollisionWorld with_extra_clearance(const CollisionWorld& world, double extra_m) {
  CollisionWorld grown = world;
  grown.tolerances.margin += extra_m;
  grown.tolerances.contact_depth -= std::min(extra_m, grown.tolerances.contact_depth) / 2;
  return grown;
}

IntervalWorld interval_world(const CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule) {
  IntervalWorld interval{with_extra_clearance(world, extra_m), nullptr, {begin_s}};
  apply(rule, begin_s, end_s, interval.world);

  auto scene = std::make_shared<Scene>(*world.scene);
  if (world.target >= 0) {
    const auto target = scene->objects.begin() + world.target;
    if (moves(*target, begin_s, end_s)) {
      scene->objects.erase(target);
      interval.world.target = -1;
    }
  }
  const bool still =
      std::none_of(scene->objects.begin(), scene->objects.end(),
                   [&](const SceneObject& object) { return moves(object, begin_s, end_s); });
  for (int k = 1; !still && k < kTimes; ++k)
    interval.times.push_back(k + 1 == kTimes ? end_s
                                             : begin_s + (end_s - begin_s) * k / (kTimes - 1));
  interval.scene = std::move(scene);
  interval.world.scene = interval.scene.get();
  return interval;
}

bool state_free(const IntervalWorld& interval, const JointVector& q, CollisionScratch& scratch) {
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    return least_slack(interval.world, q, time_s, scratch).slack() >= 0;
  });
}

bool line_free(const IntervalWorld& interval, const JointRows& reach, const JointVector& from,
               const JointVector& to, CollisionScratch& scratch) {
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    const JointMotion line = straight_motion(from, to, time_s, time_s);
    return check_motion(interval.world, reach, line, scratch).verdict == MotionVerdict::free;
  });
}

}  // namespace morphe
