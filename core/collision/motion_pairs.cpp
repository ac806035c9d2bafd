#include "core/collision/motion_pairs.hpp"

#include <algorithm>

#include "core/collision/constants.hpp"

namespace morphe::collision {
namespace {

/// Returns a lower bound of the distance of a point from an object [m].
double distance_bound(const CollisionWorld& world, const CollisionScratch& scratch,
                      const Vec3& point, int object) {
  const Pose& pose = scratch.object_poses[object];
  const Vec3 in_object = pose.linear().transpose() * (point - pose.translation());
  return signed_distance_lower_bound(solid_at(world, object), in_object);
}

}  // namespace

PairSeparation MotionPairs::unmeasured(const BodyPair& bodies) const {
  return collision::unmeasured(world, bodies, part_s);
}

void MotionPairs::set_interval(double s0, double middle, double s1) {
  motion.position(middle, scratch.position);
  motion.travel(s0, s1, scratch.travel);
  const double middle_s = motion.demonstration_time(middle);
  update_bodies(world, scratch.position, middle_s, scratch);
  for (int c = 0; c < std::ssize(scratch.bodies); ++c)
    scratch.body_travel[c] = world.robot->capsule_motion_bounds.row(c).dot(scratch.travel);
  for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
    const bool still = world.scene->objects[k].time.size() < 2 ||
                       (k == world.target && target_state != TargetState::as_recorded);
    scratch.object_travel[k] =
        still ? 0
              : object_travel(solid_at(world, k), motion.demonstration_time(s0), middle_s,
                              motion.demonstration_time(s1));
  }
}

/// Returns a bound on the relative travel of two bodies, which move with the frames a and b [m].
/// Joints above their common ancestor do not count. Levers are [joints], as in motion_bounds.hpp.
double MotionPairs::relative_travel(int a, const double* levers_a, int b,
                                    const double* levers_b) const {
  // The levers of a coupled joint include all its frames, which are adjacent: it is counted once.
  int last_joint_a = -1, last_joint_b = -1;
  double sum_m = 0;
  while (a != b) {
    // Parents come first, so the later frame is not an ancestor of the other.
    const bool a_is_later = a > b;
    const RobotModel::Frame& frame = world.robot->frames[a_is_later ? a : b];
    int& last_joint = a_is_later ? last_joint_a : last_joint_b;
    if (frame.joint >= 0 && frame.joint != last_joint) {
      sum_m += (a_is_later ? levers_a : levers_b)[frame.joint] * scratch.travel[frame.joint];
      last_joint = frame.joint;
    }
    (a_is_later ? a : b) = frame.parent;
  }
  return sum_m;
}

double MotionPairs::pair_travel(const BodyPair& pair) const {
  const robot::Robot& robot = *world.robot;
  if (pair.first_is_object) {
    const double carried_m = target_state == TargetState::attached
                                 ? world.attached.motion_bounds.dot(scratch.travel)
                                 : scratch.object_travel[pair.first];
    return carried_m + scratch.object_travel[pair.other];
  }
  const int frame = robot.capsules[pair.first].frame;
  const double* levers = robot.capsule_motion_bounds.row(pair.first).data();
  if (!pair.other_is_object) {
    return relative_travel(frame, levers, robot.capsules[pair.other].frame,
                           robot.capsule_motion_bounds.row(pair.other).data());
  }
  if (pair.other == world.target && target_state == TargetState::attached) {
    return relative_travel(frame, levers, world.attached.frame,
                           world.attached.motion_bounds.data());
  }
  return scratch.body_travel[pair.first] + scratch.object_travel[pair.other];
}

double MotionPairs::slack_lower_bound(const PairSeparation& pair) const {
  if (pair.first_is_object)
    return carried_distance_bound(world, scratch, pair.other) - pair.required_distance_m;
  const CollisionScratch::BoundingSphere& a = scratch.bounding_spheres[pair.first];
  const double padding_m = a.radius + pair.required_distance_m;
  if (!pair.other_is_object) {
    const CollisionScratch::BoundingSphere& b = scratch.bounding_spheres[pair.other];
    return (a.centre - b.centre).norm() - b.radius - padding_m;
  }
  return distance_bound(world, scratch, a.centre, pair.other) - padding_m;
}

void MotionPairs::find_near_clusters(const Excludes& excludes) {
  const double margin_m = world.tolerances.required_clearance;
  const std::vector<CapsuleCluster>& clusters = world.pairs.clusters();
  for (int c = 0; c < std::ssize(clusters); ++c) {
    CollisionScratch::Cluster& near = scratch.clusters[c];
    const double padding_m = near.sphere.radius + margin_m;
    const double* levers = cluster_levers.row(c).data();
    near.near_partners.clear();
    for (const int d : clusters[c].partners) {
      const CollisionScratch::BoundingSphere& other = scratch.clusters[d].sphere;
      const double slack_m = (near.sphere.centre - other.centre).norm() - other.radius - padding_m;
      if (!excludes(slack_m, relative_travel(clusters[c].frame, levers, clusters[d].frame,
                                             cluster_levers.row(d).data())))
        near.near_partners.push_back(d);
    }
    near.near_objects.clear();
    const double travel_m = cluster_levers.row(c).dot(scratch.travel);
    for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
      const double slack_m = distance_bound(world, scratch, near.sphere.centre, k) - padding_m;
      const bool attached = k == world.target && target_state == TargetState::attached;
      if (attached || !excludes(slack_m, travel_m + scratch.object_travel[k]))
        near.near_objects.push_back(k);
    }
  }
}

void MotionPairs::list_pairs(const Excludes& excludes) {
  find_near_clusters(excludes);
  std::vector<BodyPair>& pairs = scratch.undecided_pairs[0];
  pairs.clear();
  const int capsules = static_cast<int>(world.robot->capsules.size());
  for (int i = 0; i < capsules; ++i) {
    scratch.near_capsules.clear();
    for (const int d : scratch.clusters[world.pairs.cluster_of(i)].near_partners)
      for (const int j : world.pairs.clusters()[d].capsules)
        if (world.pairs.contains(i, j)) scratch.near_capsules.push_back(j);
    std::ranges::sort(scratch.near_capsules);
    for (const int j : scratch.near_capsules) pairs.push_back({i, j, false});
  }
  for (int i = 0; i < capsules; ++i)
    for (const int k : scratch.clusters[world.pairs.cluster_of(i)].near_objects)
      pairs.push_back({i, k, true});
  if (!is_carried(world, part_s)) return;
  for (int k = 0; k < std::ssize(world.scene->objects); ++k)
    if (k != world.target) pairs.push_back({world.target, k, true, true});
}

/// Returns the parameter at which the demonstration time reaches `time_s`, by bisection.
double MotionPairs::parameter_at_time(double time_s) const {
  double low = motion.begin, high = motion.end;
  for (int k = 0; k < kTimeBisections; ++k) {
    const double middle = 0.5 * (low + high);
    (motion.demonstration_time(middle) < time_s ? low : high) = middle;
  }
  return high;
}

bool MotionPairs::may_touch(const BodyPair& pair) const {
  return collision::may_touch(world, pair, part_s);
}

void MotionPairs::for_each_part(const std::function<bool(double, double)>& part) {
  scratch.undecided_pairs.resize(kMaxBisectionDepth + 1);
  cluster_levers = JointRows::Zero(world.pairs.clusters().size(), world.robot->joints());
  for (int i = 0; i < std::ssize(world.robot->capsules); ++i) {
    auto levers = cluster_levers.row(world.pairs.cluster_of(i));
    levers = levers.cwiseMax(world.robot->capsule_motion_bounds.row(i));
  }
  scratch.body_travel.resize(world.robot->capsules.size());
  scratch.object_travel.resize(world.scene->objects.size());
  const double begin_s = motion.demonstration_time(motion.begin);
  const double end_s = motion.demonstration_time(motion.end);
  std::vector<double> borders{world.touch_begin_s, world.touch_end_s, world.attached.begin_s,
                              world.attached.end_s, world.carried.begin_s};
  for (const SupportContact& contact : world.carried.supports) {
    borders.push_back(contact.lifted_s);
    borders.push_back(contact.lowered_s);
  }
  for (double& border_s : borders) {
    const bool inside = begin_s < border_s && border_s < end_s;
    border_s = inside ? parameter_at_time(border_s) : motion.end;  // for NaN too
  }
  borders.push_back(motion.end);
  std::ranges::sort(borders);
  double from = motion.begin;
  for (const double border : borders) {
    if (!(border > from)) continue;
    part_s = motion.demonstration_time(0.5 * (from + border));
    target_state = target_state_at(world, part_s);
    if (!part(from, border)) return;
    from = border;
  }
}

}  // namespace morphe::collision
