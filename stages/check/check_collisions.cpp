#include "stages/check/check_collisions.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/fcl_engine.hpp"

namespace morphe::check {
namespace {

constexpr double kUncertaintyBand_m = 1e-4;
/// distance between FCL's sub-samples with a margin near zero
constexpr double kMinFclStep_m = 5e-4;

void add_pair(const collision::CollisionWorld& world, const collision::PairSeparation& pair,
              std::size_t first, std::size_t last, double depth_m, FindingRows& rows) {
  const std::string one = collision::first_body_name(world, pair),
                    other = collision::second_body_name(world, pair);
  rows.add(!pair.other_is_object ? Cause::self_collision
           : other == "table"    ? Cause::table
                                 : Cause::object_collision,
           one, other, first, last, depth_m);
}

/// Adds the collisions at a sample. They extend over the steps to both its neighbours, which cannot
/// be free.
void add_at_sample(const collision::CollisionWorld& world,
                   const std::vector<collision::PairSeparation>& pairs, std::size_t sample,
                   std::size_t samples, FindingRows& rows) {
  const std::size_t before = sample > 0 ? sample - 1 : 0;
  const std::size_t after = std::min(sample + 1, samples - 1);
  for (const collision::PairSeparation& pair : pairs) {
    add_pair(world, pair, before, after, std::max(-pair.slack(), 1e-9), rows);
  }
}

struct Walk {
  const collision::CollisionWorld& world;
  const JointPath& path;
  collision::CollisionScratch scratch;
  std::vector<collision::PairSeparation> pairs;
  std::vector<collision::MotionCheck> failing;

  std::size_t samples() const { return path.demonstration_time.size(); }
  JointVector position(std::size_t sample) const { return path.position.row(sample); }
  double time_s(std::size_t sample) const { return path.demonstration_time[sample]; }

  void check_certified(FindingRows& rows) {
    for (std::size_t k = 0; k < samples(); ++k) {
      collision::near_pairs(world, position(k), time_s(k), 0, scratch, pairs);
      add_at_sample(world, pairs, k, samples(), rows);
      if (k + 1 == samples()) return;
      const collision::JointMotion motion =
          collision::straight_motion(position(k), position(k + 1), time_s(k), time_s(k + 1));
      collision::failing_pairs(world, motion, scratch, failing, kUncertaintyBand_m);
      for (const collision::MotionCheck& found : failing) {
        const double slack_m = found.pair.slack();
        const double depth_m =
            slack_m < 0 ? -slack_m : std::max(kUncertaintyBand_m - slack_m, 1e-9);
        add_pair(world, found.pair, k, k + 1, depth_m, rows);
      }
    }
  }

  /// Returns the number of equal steps such that no body travels farther than the margin in one of
  /// them; objects are assumed to move uniformly between samples.
  int fcl_steps(std::size_t k) const {
    const JointVector travel = (position(k + 1) - position(k)).cwiseAbs();
    const JointRows& levers = world.robot->capsule_motion_bounds;
    double farthest_m = levers.rows() ? (levers * travel).maxCoeff() : 0;
    double object_m = 0;
    for (std::size_t o = 0; o < world.scene->objects.size(); ++o) {
      if (world.scene->objects[o].time.size() < 2) continue;
      object_m = std::max(object_m, collision::object_travel(collision::solid_at(world, o),
                                                             time_s(k), time_s(k), time_s(k + 1)));
    }
    if (world.attached.frame >= 0) {
      object_m = std::max(object_m, world.attached.motion_bounds.dot(travel));
    }
    const double step_m = std::max(world.tolerances.required_clearance, kMinFclStep_m);
    return std::max(1, static_cast<int>(std::ceil((farthest_m + object_m) / step_m)));
  }

  void check_with_fcl(FindingRows& rows) {
    collision::FclEngine engine(world);
    for (std::size_t k = 0; k < samples(); ++k) {
      engine.colliding_pairs(position(k), time_s(k), scratch, pairs);
      add_at_sample(world, pairs, k, samples(), rows);
      if (k + 1 == samples()) return;
      const collision::JointMotion motion =
          collision::straight_motion(position(k), position(k + 1), time_s(k), time_s(k + 1));
      const int steps = fcl_steps(k);
      JointVector q;
      for (int step = 1; step < steps; ++step) {
        const double s = static_cast<double>(step) / steps;
        motion.position(s, q);
        engine.colliding_pairs(q, motion.demonstration_time(s), scratch, pairs);
        for (const collision::PairSeparation& pair : pairs) {
          add_pair(world, pair, k, k + 1, std::max(-pair.slack(), 1e-9), rows);
        }
      }
    }
  }
};

}  // namespace

void check_collisions(const collision::CollisionWorld& world, const JointPath& path, Engine engine,
                      FindingRows& rows) {
  Walk walk{world, path, {}, {}, {}};
  if (engine == Engine::fcl) {
    walk.check_with_fcl(rows);
  } else {
    walk.check_certified(rows);
  }
}

}  // namespace morphe::check
