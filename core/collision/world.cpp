#include "core/collision/world.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/collision/constants.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::collision {
namespace {

/// Returns true if two spheres, and thus the bodies in them, are at least this far apart, which
/// they always are if the distance is at most minus the sum of their radii.
bool are_separated(const CollisionScratch::BoundingSphere& a,
                   const CollisionScratch::BoundingSphere& b, double distance_m) {
  const double required_m = a.radius + b.radius + distance_m;  // of the centres
  return required_m <= 0 || (a.centre - b.centre).squaredNorm() >= required_m * required_m;
}

/// Returns true if two capsules are at least this far apart along the line between their midpoints:
/// a cheap test for neighbours, whose spheres overlap.
bool are_separated(const CapsuleBody& a, const CapsuleBody& b, double distance_m) {
  const Vec3 along = (a.from + a.to) - (b.from + b.to);  // twice the vector between the midpoints
  const double squared = along.squaredNorm();
  // Twice the gap between the segments, times the length of `along`.
  const double scaled_gap =
      squared - std::abs((a.to - a.from).dot(along)) - std::abs((b.to - b.from).dot(along));
  const double twice_required_m = 2 * (a.radius + b.radius + distance_m);
  return scaled_gap > 0 && twice_required_m > 0
             ? scaled_gap * scaled_gap >= twice_required_m * twice_required_m * squared
             : twice_required_m <= 0;
}

/// Returns a lower bound of the slack between an object and the bodies in a sphere [m].
double sphere_slack_bound(const CollisionWorld& world, const CollisionScratch& scratch,
                          const CollisionScratch::BoundingSphere& sphere, int object,
                          double required_m) {
  const Pose& pose = scratch.object_poses[object];
  const Vec3 in_object = pose.linear().transpose() * (sphere.centre - pose.translation());
  return signed_distance_lower_bound(solid_at(world, object), in_object) - sphere.radius -
         required_m;
}

/// Measures the pairs whose slack can be below `limit` and calls `visit` for each in a fixed order;
/// without `with_touching`, only for pairs that may not touch. `visit` may lower the limit, and
/// returns false to stop.
template <class Visit>
void visit_near(const CollisionWorld& world, double time_s, CollisionScratch& scratch,
                const double& limit, bool with_touching, Visit visit) {
  const auto& spheres = scratch.bounding_spheres;
  const double margin_m = world.tolerances.required_clearance;
  int tested_capsule = -1, tested_group = -1;  // the last capsule, and the group tested for it
  bool group_is_near = false;
  for (const auto& [i, j] : world.pairs) {
    if (i != tested_capsule || j / kCapsuleGroup != tested_group) {
      tested_capsule = i;
      tested_group = j / kCapsuleGroup;
      group_is_near = !are_separated(spheres[i], scratch.groups[tested_group], limit + margin_m);
    }
    if (!group_is_near || are_separated(spheres[i], spheres[j], limit + margin_m) ||
        are_separated(scratch.bodies[i], scratch.bodies[j], limit + margin_m)) {
      continue;
    }
    PairSeparation pair{{i, j, false}, {}, margin_m};
    measure(world, scratch, pair);
    if (!visit(pair)) return;
  }
  for (int i = 0; i < std::ssize(scratch.bodies); ++i) {
    if (i % kCapsuleGroup == 0) {
      // No pair requires more than the margin.
      const CollisionScratch::BoundingSphere& group = scratch.groups[i / kCapsuleGroup];
      scratch.near_group.clear();
      for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
        if (sphere_slack_bound(world, scratch, group, k, margin_m) < limit)
          scratch.near_group.push_back(k);
      }
    }
    for (const int k : scratch.near_group) {
      if (!with_touching && may_touch(world, i, k, time_s)) continue;
      PairSeparation pair{{i, k, true}, {}, required_distance_m(world, i, k, time_s)};
      if (sphere_slack_bound(world, scratch, spheres[i], k, pair.required_distance_m) >= limit)
        continue;
      measure(world, scratch, pair);
      if (!visit(pair)) return;
    }
  }
}

/// Computes the groups' spheres, each centred in the bounding box of its capsules' centres.
void place_groups(CollisionScratch& scratch) {
  const std::span all(scratch.bounding_spheres);
  scratch.groups.clear();
  for (std::size_t first = 0; first < all.size(); first += kCapsuleGroup) {
    const auto spheres =
        all.subspan(first, std::min<std::size_t>(kCapsuleGroup, all.size() - first));
    Vec3 low = spheres[0].centre, high = low;
    for (const CollisionScratch::BoundingSphere& sphere : spheres.subspan(1)) {
      low = low.cwiseMin(sphere.centre);
      high = high.cwiseMax(sphere.centre);
    }
    CollisionScratch::BoundingSphere& group = scratch.groups.emplace_back();
    group.centre = 0.5 * (low + high);
    for (const CollisionScratch::BoundingSphere& sphere : spheres)
      group.radius = std::max(group.radius, (sphere.centre - group.centre).norm() + sphere.radius);
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
  for (int i = 0; i < std::ssize(robot.capsules); ++i) {
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
  scratch.object_poses.clear();
  for (const SceneObject& object : world.scene->objects)
    scratch.object_poses.push_back(recorded_pose(object, time_s));
  if (world.attached.frame < 0 || world.target < 0) return;
  Pose& target = scratch.object_poses[world.target];
  const TargetState state = target_state_at(world, time_s);
  if (state == TargetState::attached) {
    target = scratch.base_from_frame[world.attached.frame] * world.attached.frame_from_object;
  } else if (state == TargetState::released) {
    target = world.attached.base_from_released;
  }
}

void measure(const CollisionWorld& world, const CollisionScratch& scratch, PairSeparation& pair) {
  const CapsuleBody& first = scratch.bodies[pair.capsule];
  pair.separation = pair.other_is_object ? capsule_solid(first, solid_at(world, pair.other),
                                                         scratch.object_poses[pair.other])
                                         : capsule_capsule(first, scratch.bodies[pair.other]);
}

bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  const double limit = 0;
  bool free = true;
  visit_near(world, time_s, scratch, limit, true, [&](const PairSeparation& pair) {
    free = pair.slack() >= 0;
    return free;
  });
  return free;
}

PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  PairSeparation least = no_pair();
  double least_slack_m = kInfinity;
  visit_near(world, time_s, scratch, least_slack_m, true, [&](const PairSeparation& pair) {
    if (pair.slack() < least_slack_m) {
      least = pair;
      least_slack_m = pair.slack();
    }
    return true;
  });
  return least;
}

void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  update_bodies(world, q, time_s, scratch);
  near_pairs(world, time_s, below_m, scratch, out);
}

void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out) {
  out.clear();
  visit_near(world, time_s, scratch, below_m, true, [&](const PairSeparation& pair) {
    if (pair.slack() < below_m) out.push_back(pair);
    return true;
  });
}

double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch) {
  update_bodies(world, q, time_s, scratch);
  const double margin_m = world.tolerances.required_clearance;
  double clearance_m = kInfinity, limit = kInfinity;  // limit = clearance_m - margin_m
  visit_near(world, time_s, scratch, limit, false, [&](const PairSeparation& pair) {
    clearance_m = std::min(clearance_m, pair.separation.distance);
    limit = clearance_m - margin_m;
    return true;
  });
  return clearance_m;
}

std::string first_body_name(const CollisionWorld& world, const BodyPair& pair) {
  return world.robot->capsules[pair.capsule].name;
}

std::string second_body_name(const CollisionWorld& world, const BodyPair& pair) {
  return pair.other_is_object ? world.scene->objects[pair.other].name
                              : world.robot->capsules[pair.other].name;
}

}  // namespace morphe::collision
