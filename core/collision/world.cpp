#include "core/collision/world.hpp"

#include <algorithm>
#include <cmath>

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

/// Returns true if a sphere is at least this far from the box of a cluster.
bool are_separated(const CollisionWorld& world, const CollisionScratch& scratch, int cluster,
                   const CollisionScratch::BoundingSphere& sphere, double distance_m) {
  const CapsuleCluster& box = world.pairs.clusters()[cluster];
  Vec3 point = sphere.centre - scratch.clusters[cluster].sphere.centre;
  if (box.frame >= 0) point = scratch.base_from_frame[box.frame].linear().transpose() * point;
  const double required_m = sphere.radius + distance_m;
  return required_m > 0 &&
         (point.cwiseAbs() - box.half_size).cwiseMax(0).squaredNorm() >= required_m * required_m;
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

/// Finds the partners and the objects of each cluster whose slack can be below `limit`. No pair
/// requires more than the margin.
void find_near_clusters(const CollisionWorld& world, double limit, CollisionScratch& scratch) {
  const double margin_m = world.tolerances.required_clearance;
  for (int c = 0; c < std::ssize(scratch.clusters); ++c) {
    CollisionScratch::Cluster& cluster = scratch.clusters[c];
    cluster.near_partners.clear();
    for (const int d : world.pairs.clusters()[c].partners)
      if (!are_separated(cluster.sphere, scratch.clusters[d].sphere, limit + margin_m) &&
          !are_separated(world, scratch, c, scratch.clusters[d].sphere, limit + margin_m) &&
          !are_separated(world, scratch, d, cluster.sphere, limit + margin_m))
        cluster.near_partners.push_back(d);
    cluster.near_objects.clear();
    for (int k = 0; k < std::ssize(world.scene->objects); ++k)
      if (sphere_slack_bound(world, scratch, cluster.sphere, k, margin_m) < limit)
        cluster.near_objects.push_back(k);
  }
}

bool are_separated(const CollisionScratch& scratch, int i, int j, double distance_m) {
  return are_separated(scratch.bounding_spheres[i], scratch.bounding_spheres[j], distance_m) ||
         are_separated(scratch.bodies[i], scratch.bodies[j], distance_m);
}

/// Finds the capsules after a capsule that are checked against it and can be nearer to it than
/// `distance_m`.
void find_near_capsules(const CollisionWorld& world, int capsule, double distance_m,
                        CollisionScratch& scratch) {
  scratch.near_capsules.clear();
  const CollisionScratch::BoundingSphere& sphere = scratch.bounding_spheres[capsule];
  for (const int d : scratch.clusters[world.pairs.cluster_of(capsule)].near_partners) {
    if (are_separated(world, scratch, d, sphere, distance_m)) continue;
    for (const int other : world.pairs.clusters()[d].capsules)
      if (world.pairs.contains(capsule, other) &&
          !are_separated(scratch, capsule, other, distance_m))
        scratch.near_capsules.push_back(other);
  }
  std::ranges::sort(scratch.near_capsules);
}

/// Measures the pairs whose slack can be below `limit` and calls `visit` for each in a fixed order;
/// without `with_touching`, only for pairs that may not touch. `visit` may lower the limit, and
/// returns false to stop.
template <class Visit>
void visit_near(const CollisionWorld& world, double time_s, CollisionScratch& scratch,
                const double& limit, bool with_touching, Visit visit) {
  const double margin_m = world.tolerances.required_clearance;
  find_near_clusters(world, limit, scratch);
  for (int i = 0; i < std::ssize(scratch.bodies); ++i) {
    const double distance_m = limit + margin_m;
    find_near_capsules(world, i, distance_m, scratch);
    for (const int j : scratch.near_capsules) {
      if (limit + margin_m < distance_m && are_separated(scratch, i, j, limit + margin_m)) continue;
      PairSeparation pair{{i, j, false}, {}, margin_m};
      measure(world, scratch, pair);
      if (!visit(pair)) return;
    }
  }
  for (int i = 0; i < std::ssize(scratch.bodies); ++i) {
    for (const int k : scratch.clusters[world.pairs.cluster_of(i)].near_objects) {
      if (!with_touching && may_touch(world, i, k, time_s)) continue;
      PairSeparation pair{{i, k, true}, {}, required_distance_m(world, i, k, time_s)};
      if (sphere_slack_bound(world, scratch, scratch.bounding_spheres[i], k,
                             pair.required_distance_m) >= limit)
        continue;
      measure(world, scratch, pair);
      if (!visit(pair)) return;
    }
  }
  if (!is_carried(world, time_s)) return;
  for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
    if (k == world.target || (!with_touching && carried_may_touch(world, k, time_s))) continue;
    PairSeparation pair = unmeasured(world, {world.target, k, true, true}, time_s);
    if (carried_distance_bound(world, scratch, k) - pair.required_distance_m >= limit) continue;
    measure(world, scratch, pair);
    if (!visit(pair)) return;
  }
}

void place_clusters(const CollisionWorld& world, CollisionScratch& scratch) {
  const std::vector<CapsuleCluster>& clusters = world.pairs.clusters();
  scratch.clusters.resize(clusters.size());
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const CapsuleCluster& cluster = clusters[c];
    scratch.clusters[c].sphere.centre =
        cluster.frame < 0 ? cluster.centre
                          : scratch.base_from_frame[cluster.frame] * cluster.centre;
    scratch.clusters[c].sphere.radius = cluster.radius;
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

PairSeparation unmeasured(const CollisionWorld& world, const BodyPair& bodies, double time_s) {
  const double required_m =
      bodies.first_is_object   ? carried_required_distance_m(world, bodies.other, time_s)
      : bodies.other_is_object ? required_distance_m(world, bodies.first, bodies.other, time_s)
                               : world.tolerances.required_clearance;
  return {bodies, {}, required_m};
}

bool may_touch(const CollisionWorld& world, const BodyPair& pair, double time_s) {
  return pair.first_is_object   ? carried_may_touch(world, pair.other, time_s)
         : pair.other_is_object ? may_touch(world, pair.first, pair.other, time_s)
                                : false;
}

double carried_distance_bound(const CollisionWorld& world, const CollisionScratch& scratch,
                              int object) {
  return solid_distance_lower_bound(solid_at(world, world.target),
                                    scratch.object_poses[world.target], solid_at(world, object),
                                    scratch.object_poses[object]);
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
  place_clusters(world, scratch);
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
  if (pair.first_is_object) {
    pair.separation = solid_solid(solid_at(world, pair.first), scratch.object_poses[pair.first],
                                  solid_at(world, pair.other), scratch.object_poses[pair.other]);
    return;
  }
  const CapsuleBody& first = scratch.bodies[pair.first];
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
  return pair.first_is_object ? world.scene->objects[pair.first].name
                              : world.robot->capsules[pair.first].name;
}

std::string second_body_name(const CollisionWorld& world, const BodyPair& pair) {
  return pair.other_is_object ? world.scene->objects[pair.other].name
                              : world.robot->capsules[pair.other].name;
}

}  // namespace morphe::collision
