#include "stages/repair/interval_world.hpp"

#include <algorithm>
#include <array>

#include "core/robot/tree.hpp"

namespace morphe::repair {
namespace {

/// clearance between fingers that smoothing may use up [m]
constexpr double kMaxExtraHandClearance_m = 2e-4;
constexpr int kTimeCount = 5;  ///< instants at which moving objects are checked

bool moves(const SceneObject& object, double begin_s, double end_s) {
  return object.time.size() > 1 && object.time.front() < end_s && object.time.back() > begin_s &&
         !(recorded_pose(object, begin_s).isApprox(recorded_pose(object, end_s), 1e-9) &&
           recorded_pose(object, begin_s)
               .isApprox(recorded_pose(object, (begin_s + end_s) / 2), 1e-9));
}

void apply(TouchRule rule, double begin_s, double end_s, collision::CollisionWorld& world) {
  const bool always = begin_s >= world.touch_begin_s && end_s <= world.touch_end_s;
  const bool sometimes = begin_s <= world.touch_end_s && end_s >= world.touch_begin_s;
  if (always || !sometimes) return;
  world.touch_begin_s = rule == TouchRule::strict ? kUnknown : begin_s;
  world.touch_end_s = rule == TouchRule::strict ? kUnknown : end_s;
}

/// Returns true if a capsule is fixed to the palm or to a descendant of it.
bool in_hand(const RobotModel& robot, int capsule) {
  const int frame = robot.capsules[capsule].frame;
  return robot::is_in_subtree(robot, frame, robot.palm_frame);
}

bool is_motion_free(const collision::CollisionWorld& world, const collision::JointMotion& line,
                    collision::CollisionScratch& scratch) {
  return collision::check_motion(world, line, scratch).verdict == collision::MotionVerdict::free;
}

}  // namespace

PaddedWorld padded_world(const collision::CollisionWorld& world, double extra_m) {
  PaddedWorld clear{world, world, std::make_shared<Scene>(*world.scene), std::make_shared<Scene>()};
  clear.environment.scene = clear.scene.get();
  clear.environment.tolerances.required_clearance += extra_m;
  clear.environment.tolerances.max_penetration -=
      std::min(extra_m, world.tolerances.max_penetration) / 2;
  clear.hand.scene = clear.empty_scene.get();
  clear.hand.target = -1;
  clear.hand.tolerances.required_clearance += std::min(extra_m, kMaxExtraHandClearance_m);
  const auto within_hand = [&](const std::array<int, 2>& pair) {
    return in_hand(*world.robot, pair[0]) && in_hand(*world.robot, pair[1]);
  };
  std::erase_if(clear.environment.pairs, within_hand);
  std::erase_if(clear.hand.pairs, [&](const auto& pair) { return !within_hand(pair); });
  return clear;
}

bool is_motion_free(const PaddedWorld& world, const JointVector& from, const JointVector& to,
                    double from_s, double to_s, collision::CollisionScratch& scratch) {
  const collision::JointMotion line = collision::straight_motion(from, to, from_s, to_s);
  return is_motion_free(world.environment, line, scratch) &&
         (world.hand.pairs.empty() || is_motion_free(world.hand, line, scratch));
}

IntervalWorld interval_world(const collision::CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule) {
  IntervalWorld interval{padded_world(world, extra_m), {begin_s}};
  collision::CollisionWorld& around = interval.world.environment;
  apply(rule, begin_s, end_s, around);

  auto scene = std::make_shared<Scene>(*world.scene);
  if (world.target >= 0) {
    const auto target = scene->objects.begin() + world.target;
    if (moves(*target, begin_s, end_s)) {
      scene->objects.erase(target);
      around.target = -1;
    }
  }
  const bool still =
      std::none_of(scene->objects.begin(), scene->objects.end(),
                   [&](const SceneObject& object) { return moves(object, begin_s, end_s); });
  for (int k = 1; !still && k < kTimeCount; ++k)
    interval.times.push_back(
        k + 1 == kTimeCount ? end_s : begin_s + (end_s - begin_s) * k / (kTimeCount - 1));
  interval.world.scene = std::move(scene);
  around.scene = interval.world.scene.get();
  return interval;
}

bool is_state_free(const IntervalWorld& interval, const JointVector& q,
                   collision::CollisionScratch& scratch) {
  const collision::CollisionWorld& hand = interval.world.hand;
  if (!collision::is_free(hand, q, interval.times.front(), scratch)) return false;
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    return collision::is_free(interval.world.environment, q, time_s, scratch);
  });
}

bool is_motion_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
                    collision::CollisionScratch& scratch) {
  const collision::CollisionWorld& hand = interval.world.hand;
  const collision::JointMotion line =
      collision::straight_motion(from, to, interval.times.front(), interval.times.front());
  if (!hand.pairs.empty() && !is_motion_free(hand, line, scratch)) return false;
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    return is_motion_free(interval.world.environment,
                          collision::straight_motion(from, to, time_s, time_s), scratch);
  });
}

}  // namespace morphe::repair
