#include "core/collision/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/forward.hpp"

namespace morphe::collision {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Whether two balls are at least so far apart: then the bodies in them are, too.
bool apart(const CollisionScratch::Ball& a, const CollisionScratch::Ball& b, double distance_m) {
  const double least_m = a.radius + b.radius + distance_m;
  return least_m <= 0 || (a.centre - b.centre).squaredNorm() >= least_m * least_m;
}

/// Whether two capsules are at least so far apart along the line between their middles: a cheap
/// look at those that lie side by side, whose balls meet.
bool apart(const CapsuleBody& a, const CapsuleBody& b, double distance_m) {
  const Vec3 along = (a.from + a.to) - (b.from + b.to);  // twice the way between the middles
  const double squared = along.squaredNorm();
  const double twice_gap_along =
      squared - std::abs((a.to - a.from).dot(along)) - std::abs((b.to - b.from).dot(along));
  const double twice_least_m = 2 * (a.radius + b.radius + distance_m);
  return twice_gap_along > 0 && twice_least_m > 0
             ? twice_gap_along * twice_gap_along >= twice_least_m * twice_least_m * squared
             : twice_least_m <= 0;
}

/// At most the slack of what lies in the ball.
double ball_slack(const CollisionWorld& world, const CollisionScratch& scratch,
                  const CollisionScratch::Ball& ball, std::size_t object, double required_m) {
  const Pose& pose = scratch.object_poses[object];
  const Vec3 in_object = pose.linear().transpose() * (ball.centre - pose.translation());
  return signed_distance_at_least(solid_at(world, object), in_object) - ball.radius - required_m;
}

/// Visits every pair whose slack can be below `limit`, in the fixed order; `visit` may lower it,
/// and says whether to go on. required(capsule, object) is called for objects only; -infinity
/// leaves the pair out.
template <class Required, class Visit>
void visit_near(const CollisionWorld& world, CollisionScratch& scratch, const double& limit,
                Required required, Visit visit) {
  PairSeparation pair;
  pair.required = world.tolerances.margin;
  std::size_t of = kNone, row = kNone;  // the last capsule, and the group looked at for it
  bool beside = false;
  for (const auto& [i, j] : world.pairs) {
    const auto first = static_cast<std::size_t>(i), second = static_cast<std::size_t>(j);
    if (first != of || second / kCapsuleGroup != row) {
      of = first;
      row = second / kCapsuleGroup;
      beside = !apart(scratch.balls[first], scratch.groups[row], limit + pair.required);
    }
    if (!beside) continue;
    if (apart(scratch.balls[first], scratch.balls[second], limit + pair.required) ||
        apart(scratch.bodies[first], scratch.bodies[second], limit + pair.required)) {
      continue;
    }
    pair.capsule = i;
    pair.other = j;
    pair.separation = capsule_capsule(scratch.bodies[first], scratch.bodies[second]);
    if (!visit(pair)) return;
  }
  pair.object = true;
  const std::size_t objects = world.scene->objects.size();
  for (std::size_t i = 0; i < scratch.bodies.size(); ++i) {
    if (i % kCapsuleGroup == 0) {
      // No pair asks for more than the margin.
      const CollisionScratch::Ball& group = scratch.groups[i / kCapsuleGroup];
      scratch.near_group.clear();
      for (std::size_t k = 0; k < objects; ++k) {
        if (ball_slack(world, scratch, group, k, world.tolerances.margin) < limit) {
          scratch.near_group.push_back(k);
        }
      }
    }
    for (const std::size_t k : scratch.near_group) {
      pair.capsule = static_cast<int>(i);
      pair.other = static_cast<int>(k);
      pair.required = required(pair.capsule, pair.other);
      if (ball_slack(world, scratch, scratch.balls[i], k, pair.required) >= limit) continue;
      pair.separation =
          capsule_solid(scratch.bodies[i], solid_at(world, k), scratch.object_poses[k]);
      if (!visit(pair)) return;
    }
  }
}

/// About the middle of the balls' box.
void place_groups(CollisionScratch& scratch) {
  const std::size_t count = scratch.balls.size();
  scratch.groups.resize((count + kCapsuleGroup - 1) / kCapsuleGroup);
  for (std::size_t g = 0; g < scratch.groups.size(); ++g) {
    const std::size_t first = g * kCapsuleGroup, last = std::min(first + kCapsuleGroup, count);
    Vec3 low = scratch.balls[first].centre, high = low;
    for (std::size_t i = first + 1; i < last; ++i) {
      low = low.cwiseMin(scratch.balls[i].centre);
      high = high.cwiseMax(scratch.balls[i].centre);
    }
    CollisionScratch::Ball& group = scratch.groups[g];
    group = {0.5 * (low + high), 0};
    for (std::size_t i = first; i < last; ++i) {
      const CollisionScratch::Ball& ball = scratch.balls[i];
      group.radius = std::max(group.radius, (ball.centre - group.centre).norm() + ball.radius);
    }
  }
}

}  // namespace

bool may_touch(const CollisionWorld& world, int capsule, int object, double time_s) {
  return object == world.target && time_s >= world.touch_begin_s && time_s <= world.touch_end_s &&
         world.robot->capsules[static_cast<std::size_t>(capsule)].may_touch_target;
}

double touch_depth_m(const CollisionWorld& world, int capsule) {
  const Tolerances& allowed = world.tolerances;
  return robot::is_pad(*world.robot, capsule) ? allowed.contact_depth
                                              : allowed.link_depth.value_or(allowed.contact_depth);
}

double required_m(const CollisionWorld& world, int capsule, int object, double time_s) {
  return may_touch(world, capsule, object, time_s) ? -touch_depth_m(world, capsule)
                                                   : world.tolerances.margin;
}

void pose_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch) {
  robot::forward(*world.robot, q, scratch.base_from_frame);
  place_bodies(world, time_s, scratch);
}

void place_bodies(const CollisionWorld& world, double time_s, CollisionScratch& scratch) {
  const RobotTable& robot = *world.robot;
  scratch.bodies.resize(robot.capsules.size());
  scratch.balls.resize(robot.capsules.size());
  for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
    const RobotTable::Capsule& capsule = robot.capsules[i];
    CapsuleBody& body = scratch.bodies[i];
    if (capsule.frame < 0) {
      body = {capsule.from, capsule.to, capsule.radius};
    } else {
      const Pose& pose = scratch.base_from_frame[static_cast<std::size_t>(capsule.frame)];
      body = {pose * capsule.from, pose * capsule.to, capsule.radius};
    }
    scratch.balls[i].centre = 0.5 * (body.from + body.to);
    scratch.balls[i].radius = 0.5 * (body.to - body.from).norm() + body.radius;
  }
  place_groups(scratch);
  scratch.object_poses.resize(world.scene->objects.size());
  for (std::size_t k = 0; k < world.scene->objects.size(); ++k) {
    scratch.object_poses[k] = recorded_pose(world.scene->objects[k], time_s);
  }
  if (world.carried.frame < 0 || world.target < 0) return;
  Pose& target = scratch.object_poses[static_cast<std::size_t>(world.target)];
  const TargetPlace place = place_of_target(world, time_s);
  if (place == TargetPlace::in_hand) {
    target = scratch.base_from_frame[static_cast<std::size_t>(world.carried.frame)] *
             world.carried.frame_from_object;
  } else if (place == TargetPlace::released) {
    target = world.carried.base_from_released;
  }
}

bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch) {
  pose_bodies(world, q, time_s, scratch);
  const double limit = 0;
  bool free = true;
  visit_near(
      world, scratch, limit,
      [&](int capsule, int object) { return required_m(world, capsule, object, time_s); },
      [&](const PairSeparation& pair) {
        free = pair.slack() >= 0;
        return free;
      });
  return free;
}

PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch) {
  pose_bodies(world, q, time_s, scratch);
  PairSeparation best;
  best.capsule = -1;
  best.separation.distance = kInfinity;
  double least = kInfinity;
  visit_near(
      world, scratch, least,
      [&](int capsule, int object) { return required_m(world, capsule, object, time_s); },
      [&](const PairSeparation& pair) {
        if (pair.slack() < least) {
          best = pair;
          least = pair.slack();
        }
        return true;
      });
  return best;
}

void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  pose_bodies(world, q, time_s, scratch);
  near_pairs(world, time_s, below_m, scratch, out);
}

void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  out.clear();
  visit_near(
      world, scratch, below_m,
      [&](int capsule, int object) { return required_m(world, capsule, object, time_s); },
      [&](const PairSeparation& pair) {
        if (pair.slack() < below_m) out.push_back(pair);
        return true;
      });
}

double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch) {
  pose_bodies(world, q, time_s, scratch);
  const double margin_m = world.tolerances.margin;
  double least_m = kInfinity, limit = kInfinity;  // limit = least_m - margin_m
  visit_near(
      world, scratch, limit,
      [&](int capsule, int object) {
        return may_touch(world, capsule, object, time_s) ? -kInfinity : margin_m;
      },
      [&](const PairSeparation& pair) {
        least_m = std::min(least_m, pair.separation.distance);
        limit = least_m - margin_m;
        return true;
      });
  return least_m;
}

std::string first_name(const CollisionWorld& world, const PairSeparation& pair) {
  return world.robot->capsules[static_cast<std::size_t>(pair.capsule)].name;
}

std::string second_name(const CollisionWorld& world, const PairSeparation& pair) {
  const auto other = static_cast<std::size_t>(pair.other);
  return pair.object ? world.scene->objects[other].name : world.robot->capsules[other].name;
}

}  // namespace morphe::collision
