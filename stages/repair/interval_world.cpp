#include "stages/repair/interval_world.hpp"

#include <algorithm>
#include <array>

#include "core/robot/tree.hpp"
#include "stages/repair/constants.hpp"

namespace morphe::repair {
namespace {

bool moves_in(const SceneObject& object, double begin_s, double end_s) {
  const auto at_begin_pose = [&](double t) {
    return recorded_pose(object, begin_s).isApprox(recorded_pose(object, t), kRestPoseTolerance);
  };
  return object.time.size() > 1 && object.time.front() < end_s && object.time.back() > begin_s &&
         !(at_begin_pose(end_s) && at_begin_pose((begin_s + end_s) / 2));
}

void apply_rule(TouchRule rule, double begin_s, double end_s, collision::CollisionWorld& world) {
  const bool always = begin_s >= world.touch_begin_s && end_s <= world.touch_end_s;
  const bool sometimes = begin_s <= world.touch_end_s && end_s >= world.touch_begin_s;
  if (always || !sometimes) return;
  world.touch_begin_s = rule == TouchRule::strict ? kUnknown : begin_s;
  world.touch_end_s = rule == TouchRule::strict ? kUnknown : end_s;
}

/// Applies the rule to the contacts of a carried target with its supports.
void apply_rule_to_supports(TouchRule rule, double begin_s, double end_s,
                            collision::CarriedTarget& carried) {
  for (collision::SupportContact& contact : carried.supports) {
    const bool always = end_s <= contact.lifted_s || begin_s >= contact.lowered_s ||
                        contact.lifted_s >= contact.lowered_s;
    const bool sometimes = contact.is_allowed(begin_s) || contact.is_allowed(end_s);
    if (always || !sometimes) continue;
    contact.lifted_s = rule == TouchRule::strict ? -kInfinity : kInfinity;
    contact.lowered_s = kInfinity;
  }
}

/// Returns true if the target is attached, or has been released, in the whole interval.
bool is_off_recording(const collision::CollisionWorld& world, double begin_s, double end_s) {
  const collision::TargetState state = collision::target_state_at(world, begin_s);
  return state != collision::TargetState::as_recorded &&
         state == collision::target_state_at(world, end_s);
}

bool in_hand(const RobotModel& robot, int capsule) {
  return robot::is_in_subtree(robot, robot.capsules[capsule].frame, robot.palm_frame);
}

bool is_motion_free(const collision::CollisionWorld& world, const collision::JointMotion& line,
                    collision::CollisionScratch& scratch) {
  return collision::check_motion(world, line, scratch).verdict == collision::MotionVerdict::free;
}

}  // namespace

PaddedWorld padded_world(const collision::CollisionWorld& world, double extra_m) {
  PaddedWorld padded{world, world, std::make_shared<Scene>(*world.scene),
                     std::make_shared<Scene>()};
  padded.environment.scene = padded.scene.get();
  padded.environment.tolerances.required_clearance += extra_m;
  padded.environment.tolerances.max_penetration -=
      kMaxPenetrationLossRatio * std::min(extra_m, world.tolerances.max_penetration);
  padded.hand.scene = padded.empty_scene.get();
  padded.hand.target = -1;
  padded.hand.tolerances.required_clearance += std::min(extra_m, kMaxExtraHandClearance_m);
  const auto within_hand = [&](const std::array<int, 2>& pair) {
    return in_hand(*world.robot, pair[0]) && in_hand(*world.robot, pair[1]);
  };
  padded.environment.pairs.erase_if(within_hand);
  padded.hand.pairs.erase_if([&](const auto& pair) { return !within_hand(pair); });
  return padded;
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
  collision::CollisionWorld& environment = interval.world.environment;
  apply_rule(rule, begin_s, end_s, environment);
  apply_rule_to_supports(rule, begin_s, end_s, environment.carried);

  auto scene = std::make_shared<Scene>(*world.scene);
  if (world.target >= 0) {
    const auto target = scene->objects.begin() + world.target;
    if (moves_in(*target, begin_s, end_s) && !is_off_recording(world, begin_s, end_s)) {
      scene->objects.erase(target);
      environment.target = -1;
    }
  }
  const bool moving = std::ranges::any_of(
      scene->objects, [&](const SceneObject& object) { return moves_in(object, begin_s, end_s); });
  const int steps = kIntervalTimeCount - 1;
  for (int k = 1; moving && k <= steps; ++k)
    interval.times.push_back(k == steps ? end_s : begin_s + (end_s - begin_s) * k / steps);
  interval.world.scene = std::move(scene);
  environment.scene = interval.world.scene.get();
  return interval;
}

bool is_state_free(const IntervalWorld& interval, const JointVector& q,
                   collision::CollisionScratch& scratch) {
  if (!collision::is_free(interval.world.hand, q, interval.times.front(), scratch)) return false;
  return std::ranges::all_of(interval.times, [&](double time_s) {
    return collision::is_free(interval.world.environment, q, time_s, scratch);
  });
}

bool is_motion_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
                    collision::CollisionScratch& scratch) {
  const collision::CollisionWorld& hand = interval.world.hand;
  const collision::JointMotion line =
      collision::straight_motion(from, to, interval.times.front(), interval.times.front());
  if (!hand.pairs.empty() && !is_motion_free(hand, line, scratch)) return false;
  return std::ranges::all_of(interval.times, [&](double time_s) {
    return is_motion_free(interval.world.environment,
                          collision::straight_motion(from, to, time_s, time_s), scratch);
  });
}

}  // namespace morphe::repair
