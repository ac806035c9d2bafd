#include "core/collision/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::collision {
namespace {

constexpr std::size_t kNoBody = std::numeric_limits<std::size_t>::max();

/// Returns true if two spheres, and thus the bodies in them, are at least this far apart.
bool are_separated(const CollisionScratch::BoundingSphere& a,
                   const CollisionScratch::BoundingSphere& b, double distance_m) {
  const double least_m = a.radius + b.radius + distance_m;
  return least_m <= 0 || (a.centre - b.centre).squaredNorm() >= least_m * least_m;
}

/// Returns true if two capsules are at least this far apart along the line between their midpoints:
/// a cheap test for capsules side by side, whose spheres overlap.
bool are_separated(const CapsuleBody& a, const CapsuleBody& b, double distance_m) {
  const Vec3 along = (a.from + a.to) - (b.from + b.to);  // twice the vector between the midpoints
  const double squared = along.squaredNorm();
  const double twice_gap_along =
      squared - std::abs((a.to - a.from).dot(along)) - std::abs((b.to - b.from).dot(along));
  const double twice_least_m = 2 * (a.radius + b.radius + distance_m);
  return twice_gap_along > 0 && twice_least_m > 0
             ? twice_gap_along * twice_gap_along >= twice_least_m * twice_least_m * squared
             : twice_least_m <= 0;
}

/// Returns a lower bound of the slack of the bodies in a sphere.
double sphere_slack_bound(const CollisionWorld& world, const CollisionScratch& scratch,
                          const CollisionScratch::BoundingSphere& ball, std::size_t object,
                          double required_m) {
  const Pose& pose = scratch.object_poses[object];
  const Vec3 in_object = pose.linear().transpose() * (ball.centre - pose.translation());
  return signed_distance_lower_bound(solid_at(world, object), in_object) - ball.radius - required_m;
}

/// Visits every pair whose slack can be below `limit`, in a fixed order. `visit` may lower the
/// limit, and returns false to stop. required(capsule, object) is called for objects only;
/// -infinity excludes the pair.
template <class Required, class Visit>
void visit_near(const CollisionWorld& world, CollisionScratch& scratch, const double& limit,
                Required required, Visit visit) {
  PairSeparation pair;
  pair.required_distance_m = world.tolerances.required_clearance;
  // The last capsule, and the group that was tested for it.
  std::size_t of = kNoBody, row = kNoBody;
  bool beside = false;
  for (const auto& [i, j] : world.pairs) {
    const auto first = static_cast<std::size_t>(i), second = j;
    if (first != of || second / kCapsuleGroup != row) {
      of = first;
      row = second / kCapsuleGroup;
      beside = !are_separated(scratch.bounding_spheres[first], scratch.groups[row],
                              limit + pair.required_distance_m);
    }
    if (!beside) continue;
    if (are_separated(scratch.bounding_spheres[first], scratch.bounding_spheres[second],
                      limit + pair.required_distance_m) ||
        are_separated(scratch.bodies[first], scratch.bodies[second],
                      limit + pair.required_distance_m)) {
      continue;
    }
    pair.capsule = i;
    pair.other = j;
    pair.separation = capsule_capsule(scratch.bodies[first], scratch.bodies[second]);
    if (!visit(pair)) return;
  }
  pair.other_is_object = true;
  const std::size_t objects = world.scene->objects.size();
  for (std::size_t i = 0; i < scratch.bodies.size(); ++i) {
    if (i % kCapsuleGroup == 0) {
      // No pair requires more than the margin.
      const CollisionScratch::BoundingSphere& group = scratch.groups[i / kCapsuleGroup];
      scratch.near_group.clear();
      for (std::size_t k = 0; k < objects; ++k) {
        if (sphere_slack_bound(world, scratch, group, k, world.tolerances.required_clearance) <
            limit) {
          scratch.near_group.push_back(k);
        }
      }
    }
    for (const std::size_t k : scratch.near_group) {
      pair.capsule = static_cast<int>(i);
      pair.other = static_cast<int>(k);
      pair.required_distance_m = required(pair.capsule, pair.other);
      if (sphere_slack_bound(world, scratch, scratch.bounding_spheres[i], k,
                             pair.required_distance_m) >= limit)
        continue;
      pair.separation =
          capsule_solid(scratch.bodies[i], solid_at(world, k), scratch.object_poses[k]);
      if (!visit(pair)) return;
    }
  }
}

/// Computes the groups' spheres, centred in the bounding boxes of their spheres.
void place_groups(CollisionScratch& scratch) {
  const std::size_t count = scratch.bounding_spheres.size();
  scratch.groups.resize((count + kCapsuleGroup - 1) / kCapsuleGroup);
  for (std::size_t g = 0; g < scratch.groups.size(); ++g) {
    const std::size_t first = g * kCapsuleGroup, last = std::min(first + kCapsuleGroup, count);
    Vec3 low = scratch.bounding_spheres[first].centre, high = low;
    for (std::size_t i = first + 1; i < last; ++i) {
      low = low.cwiseMin(scratch.bounding_spheres[i].centre);
      high = high.cwiseMax(scratch.bounding_spheres[i].centre);
    }
    CollisionScratch::BoundingSphere& group = scratch.groups[g];
    group = {0.5 * (low + high), 0};
    for (std::size_t i = first; i < last; ++i) {
      const CollisionScratch::BoundingSphere& ball = scratch.bounding_spheres[i];
      group.radius = std::max(group.radius, (ball.centre - group.centre).norm() + ball.radius);
    }
  }
}

}  // namespace

bool may_touch(const CollisionWorld& world, int capsule, int object, double time_s) {
  return object == world.target && time_s >= world.touch_begin_s && time_s <= world.touch_end_s &&
         world.robot->capsules[capsule].may_touch_target;
}

double allowed_contact_depth_m(const CollisionWorld& world, int capsule) {
  const Tolerances& allowed = world.tolerances;
  return robot::is_pad(*world.robot, capsule)
             ? allowed.max_penetration
             : allowed.max_link_penetration.value_or(allowed.max_penetration);
}

double required_distance_m(const CollisionWorld& world, int capsule, int object, double time_s) {
  return may_touch(world, capsule, object, time_s) ? -allowed_contact_depth_m(world, capsule)
                                                   : world.tolerances.required_clearance;
}

void update_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                   double time_s, CollisionScratch& scratch) {
  robot::forward_kinematics(*world.robot, q, scratch.base_from_frame);
  update_bodies_from_frames(world, time_s, scratch);
}

void update_bodies_from_frames(const CollisionWorld& world, double time_s,
                               CollisionScratch& scratch) {
  const RobotModel& robot = *world.robot;
  scratch.bodies.resize(robot.capsules.size());
  scratch.bounding_spheres.resize(robot.capsules.size());
  for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
    const RobotModel::Capsule& capsule = robot.capsules[i];
    CapsuleBody& body = scratch.bodies[i];
    if (capsule.frame < 0) {
      body = {capsule.from, capsule.to, capsule.radius};
    } else {
      const Pose& pose = scratch.base_from_frame[capsule.frame];
      body = {pose * capsule.from, pose * capsule.to, capsule.radius};
    }
    scratch.bounding_spheres[i].centre = 0.5 * (body.from + body.to);
    scratch.bounding_spheres[i].radius = 0.5 * (body.to - body.from).norm() + body.radius;
  }
  place_groups(scratch);
  scratch.object_poses.resize(world.scene->objects.size());
  for (std::size_t k = 0; k < world.scene->objects.size(); ++k) {
    scratch.object_poses[k] = recorded_pose(world.scene->objects[k], time_s);
  }
  if (world.attached.frame < 0 || world.target < 0) return;
  Pose& target = scratch.object_poses[world.target];
  const TargetState place = target_state_at(world, time_s);
  if (place == TargetState::attached) {
    target = scratch.base_from_frame[world.attached.frame] * world.attached.frame_from_object;
  } else if (place == TargetState::released) {
    target = world.attached.base_from_released;
  }
}

bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  const double limit = 0;
  bool free = true;
  visit_near(
      world, scratch, limit,
      [&](int capsule, int object) { return required_distance_m(world, capsule, object, time_s); },
      [&](const PairSeparation& pair) {
        free = pair.slack() >= 0;
        return free;
      });
  return free;
}

PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  PairSeparation best;
  best.capsule = -1;
  best.separation.distance = kInfinity;
  double least = kInfinity;
  visit_near(
      world, scratch, least,
      [&](int capsule, int object) { return required_distance_m(world, capsule, object, time_s); },
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
  update_bodies(world, q, time_s, scratch);
  near_pairs(world, time_s, below_m, scratch, out);
}

void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  out.clear();
  visit_near(
      world, scratch, below_m,
      [&](int capsule, int object) { return required_distance_m(world, capsule, object, time_s); },
      [&](const PairSeparation& pair) {
        if (pair.slack() < below_m) out.push_back(pair);
        return true;
      });
}

double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  const double margin_m = world.tolerances.required_clearance;
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

std::string first_body_name(const CollisionWorld& world, const PairSeparation& pair) {
  return world.robot->capsules[pair.capsule].name;
}

std::string second_body_name(const CollisionWorld& world, const PairSeparation& pair) {
  const auto other = static_cast<std::size_t>(pair.other);
  return pair.other_is_object ? world.scene->objects[other].name
                              : world.robot->capsules[other].name;
}

}  // namespace morphe::collision
