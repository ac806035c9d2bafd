#include "stages/check/check_collisions.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/continuous_check.hpp"
#include "core/collision/fcl_engine.hpp"

namespace morphe::check {
namespace {

using collision::CollisionWorld;
using collision::PairSeparation;

constexpr double kUncertaintyBand_m = 1e-4;  ///< slack below which a motion may stay undecided
constexpr double kMinFclStep_m = 5e-4;       ///< between FCL's sub-samples with a margin near zero

void add_pair(const CollisionWorld& world, const PairSeparation& pair, int first, int last,
              double depth_m, FindingRows& rows) {
  const std::string other = collision::second_body_name(world, pair);
  const Cause cause = !pair.other_is_object ? Cause::self_collision
                      : other == "table"    ? Cause::table
                                            : Cause::object_collision;
  rows.add({.cause = cause,
            .subject = collision::first_body_name(world, pair),
            .other_body = other,
            .excess = depth_m,
            .limit = pair.required_distance_m},
           first, last);
}

void add_pairs(const CollisionWorld& world, const std::vector<PairSeparation>& pairs, int first,
               int last, FindingRows& rows) {
  for (const PairSeparation& pair : pairs) {
    add_pair(world, pair, first, last, std::max(-pair.slack(), 1e-9), rows);
  }
}

/// Calls collide_at(q, time_s, pairs) at every sample k and adds the pairs over the steps to both
/// neighbours, which are not free either. Then calls between(k, motion) for the straight line from
/// sample k to the next one.
template <class CollideAt, class Between>
void walk(const CollisionWorld& world, const JointPath& path, FindingRows& rows,
          const CollideAt& collide_at, const Between& between) {
  const std::vector<double>& time_s = path.demonstration_time;
  const int last = static_cast<int>(std::ssize(time_s)) - 1;
  std::vector<PairSeparation> pairs;
  for (int k = 0; k <= last; ++k) {
    const JointVector q = path.position.row(k);
    collide_at(q, time_s[k], pairs);
    add_pairs(world, pairs, std::max(0, k - 1), std::min(k + 1, last), rows);
    if (k == last) return;
    between(k, collision::straight_motion(q, path.position.row(k + 1), time_s[k], time_s[k + 1]));
  }
}

/// Returns the number of equal steps from sample k to the next one in which no body travels farther
/// than the margin, or kMinFclStep_m. Objects are assumed to move uniformly between samples.
int fcl_steps(const CollisionWorld& world, const JointPath& path, int k) {
  const JointVector travel =
      (JointVector(path.position.row(k + 1)) - JointVector(path.position.row(k))).cwiseAbs();
  const double begin_s = path.demonstration_time[k], end_s = path.demonstration_time[k + 1];
  const JointRows& levers = world.robot->capsule_motion_bounds;
  const double robot_m = levers.rows() ? (levers * travel).maxCoeff() : 0;
  double object_m = 0;
  for (int o = 0; o < std::ssize(world.scene->objects); ++o) {
    if (world.scene->objects[o].time.size() < 2) continue;
    object_m = std::max(
        object_m, collision::object_travel(collision::solid_at(world, o), begin_s, begin_s, end_s));
  }
  if (world.attached.frame >= 0) {
    object_m = std::max(object_m, world.attached.motion_bounds.dot(travel));
  }
  const double step_m = std::max(world.tolerances.required_clearance, kMinFclStep_m);
  return std::max(1, static_cast<int>(std::ceil((robot_m + object_m) / step_m)));
}

}  // namespace

void check_certified(const CollisionWorld& world, const JointPath& path, FindingRows& rows) {
  collision::CollisionScratch scratch;
  std::vector<collision::MotionCheck> failing;
  const auto near = [&](const JointVector& q, double time_s, std::vector<PairSeparation>& pairs) {
    collision::near_pairs(world, q, time_s, 0, scratch, pairs);
  };
  walk(world, path, rows, near, [&](int k, const collision::JointMotion& motion) {
    collision::failing_pairs(world, motion, scratch, failing, kUncertaintyBand_m);
    for (const collision::MotionCheck& found : failing) {
      const double slack_m = found.pair.slack();
      const double depth_m = slack_m < 0 ? -slack_m : std::max(kUncertaintyBand_m - slack_m, 1e-9);
      add_pair(world, found.pair, k, k + 1, depth_m, rows);
    }
  });
}

void check_with_fcl(const CollisionWorld& world, const JointPath& path, FindingRows& rows) {
  collision::FclEngine engine(world);
  collision::CollisionScratch scratch;
  const auto collide = [&](const JointVector& q, double time_s,
                           std::vector<PairSeparation>& pairs) {
    engine.colliding_pairs(q, time_s, scratch, pairs);
  };
  walk(world, path, rows, collide, [&](int k, const collision::JointMotion& motion) {
    const int steps = fcl_steps(world, path, k);
    JointVector q;
    std::vector<PairSeparation> pairs;
    for (int step = 1; step < steps; ++step) {
      const double s = static_cast<double>(step) / steps;
      motion.position(s, q);
      engine.colliding_pairs(q, motion.demonstration_time(s), scratch, pairs);
      add_pairs(world, pairs, k, k + 1, rows);
    }
  });
}

}  // namespace morphe::check
