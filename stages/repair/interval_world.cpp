#include "stages/repair/interval_world.hpp"

#include <algorithm>
#include <array>

#include "core/robot/tree.hpp"

namespace morphe::repair {
namespace {

constexpr double kHandRoom = 2e-4;  ///< what smoothing takes of the clearance between fingers [m]
constexpr int kTimes = 5;           ///< at which moving objects are looked at

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
  world.touch_begin_s = rule == TouchRule::strict ? kNotSeen : begin_s;
  world.touch_end_s = rule == TouchRule::strict ? kNotSeen : end_s;
}

/// Whether a capsule hangs on the palm or on a frame beyond it.
bool in_hand(const RobotTable& robot, int capsule) {
  const int frame = robot.capsules[static_cast<std::size_t>(capsule)].frame;
  return robot::hangs_on(robot, frame, robot.palm_frame);
}

bool line_free(const collision::CollisionWorld& world, const collision::JointMotion& line,
               collision::CollisionScratch& scratch) {
  return collision::check_motion(world, line, scratch).verdict == collision::MotionVerdict::free;
}

}  // namespace

ClearWorld clear_world(const collision::CollisionWorld& world, double extra_m) {
  ClearWorld clear{world, world, std::make_shared<Scene>(*world.scene), std::make_shared<Scene>()};
  clear.around.scene = clear.scene.get();
  clear.around.tolerances.margin += extra_m;
  clear.around.tolerances.contact_depth -= std::min(extra_m, world.tolerances.contact_depth) / 2;
  clear.hand.scene = clear.nothing.get();
  clear.hand.target = -1;
  clear.hand.tolerances.margin += std::min(extra_m, kHandRoom);
  const auto within_hand = [&](const std::array<int, 2>& pair) {
    return in_hand(*world.robot, pair[0]) && in_hand(*world.robot, pair[1]);
  };
  std::erase_if(clear.around.pairs, within_hand);
  std::erase_if(clear.hand.pairs, [&](const auto& pair) { return !within_hand(pair); });
  return clear;
}

bool line_free(const ClearWorld& world, const JointVector& from, const JointVector& to,
               double from_s, double to_s, collision::CollisionScratch& scratch) {
  const collision::JointMotion line = collision::straight_motion(from, to, from_s, to_s);
  return line_free(world.around, line, scratch) &&
         (world.hand.pairs.empty() || line_free(world.hand, line, scratch));
}

IntervalWorld interval_world(const collision::CollisionWorld& world, double begin_s, double end_s,
                             double extra_m, TouchRule rule) {
  IntervalWorld interval{clear_world(world, extra_m), {begin_s}};
  collision::CollisionWorld& around = interval.world.around;
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
  for (int k = 1; !still && k < kTimes; ++k)
    interval.times.push_back(k + 1 == kTimes ? end_s
                                             : begin_s + (end_s - begin_s) * k / (kTimes - 1));
  interval.world.scene = std::move(scene);
  around.scene = interval.world.scene.get();
  return interval;
}

bool state_free(const IntervalWorld& interval, const JointVector& q,
                collision::CollisionScratch& scratch) {
  const collision::CollisionWorld& hand = interval.world.hand;
  if (!collision::is_free(hand, q, interval.times.front(), scratch)) return false;
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    return collision::is_free(interval.world.around, q, time_s, scratch);
  });
}

bool line_free(const IntervalWorld& interval, const JointVector& from, const JointVector& to,
               collision::CollisionScratch& scratch) {
  const collision::CollisionWorld& hand = interval.world.hand;
  const collision::JointMotion line =
      collision::straight_motion(from, to, interval.times.front(), interval.times.front());
  if (!hand.pairs.empty() && !line_free(hand, line, scratch)) return false;
  return std::all_of(interval.times.begin(), interval.times.end(), [&](double time_s) {
    return line_free(interval.world.around, collision::straight_motion(from, to, time_s, time_s),
                     scratch);
  });
}

}  // namespace morphe::repair
