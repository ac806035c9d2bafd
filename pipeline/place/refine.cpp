#include "pipeline/place/refine.hpp"

#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/place/reachability_grid.hpp"

namespace morphe::place {
namespace {
struct EvaluatedPlacement {
  Candidate candidate;
  std::vector<JointRows> q;  ///< [trials]
};

EvaluatedPlacement evaluate(const BasePlacement& pose, std::vector<TrialMapping> mappings) {
  EvaluatedPlacement evaluated;
  std::vector<PlacementMeasures> all;
  for (TrialMapping& mapping : mappings) {
    all.push_back(mapping.measures);
    evaluated.q.push_back(std::move(mapping.q));
  }
  const PlacementMeasures mean = mean_of(all);
  evaluated.candidate = {pose, mean, cost_of(mean)};
  return evaluated;
}

EvaluatedPlacement map_all_from_random(const planning::PlanningInputs& planner,
                                       const BasePlacement& pose,
                                       const std::vector<const TrialMovement*>& trials,
                                       const SearchEffort& effort, std::uint64_t seed) {
  std::vector<TrialMapping> mappings;
  for (int k = 0; k < std::ssize(trials); ++k)
    mappings.push_back(map_from_random_starts(planner, pose, *trials[k], effort,
                                              math::seed_from(seed, "trial", k)));
  return evaluate(pose, std::move(mappings));
}

EvaluatedPlacement map_all_from_warm(const planning::PlanningInputs& planner,
                                     const BasePlacement& pose,
                                     const std::vector<TrialMovement>& trials,
                                     const EvaluatedPlacement& warm_start) {
  std::vector<TrialMapping> mappings;
  for (int k = 0; k < std::ssize(trials); ++k)
    mappings.push_back(
        map_from_warm_start(planner, pose, trials[k], kRefinementEffort, warm_start.q[k]));
  return evaluate(pose, std::move(mappings));
}

/// Returns the pose after a step: a shift along the world's axis 0 … 2, or a turn about it for 3
/// … 5.
BasePlacement take_step(const BasePlacement& pose, int direction, double shift_m, double turn_rad) {
  BasePlacement next = pose;
  const Vec3 axis = Vec3::Unit(direction % 3);
  if (direction < 3) {
    next.shoulder_offset += shift_m * axis;
  } else {
    next.world_from_base =
        (Quat(Eigen::AngleAxisd(turn_rad, axis)) * pose.world_from_base).normalized();
  }
  return next;
}

bool is_same_placement(const BasePlacement& a, const BasePlacement& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < 1e-6 &&
         angle_between(a.world_from_base, b.world_from_base) < 1e-6;
}

}  // namespace

Candidate evaluate_placement(const planning::PlanningInputs& planner, const BasePlacement& pose,
                             const std::vector<const TrialMovement*>& trials,
                             const SearchEffort& effort, std::uint64_t seed) {
  return map_all_from_random(planner, pose, trials, effort, seed).candidate;
}

Candidate refine(const planning::PlanningInputs& planner, const BasePlacement& start,
                 const CompassSteps& steps, const BasePlacement& configured,
                 const std::vector<TrialMovement>& trials, const Vec3& robot_shoulder,
                 const PlaceOptions& options, std::uint64_t seed) {
  std::vector<const TrialMovement*> all;
  for (const TrialMovement& trial : trials) all.push_back(&trial);
  const auto map_all = [&](const BasePlacement& pose, std::uint64_t level_seed) {
    return map_all_from_random(planner, pose, all, kRefinementEffort, level_seed);
  };
  double shift_m = steps.shift_m, turn_rad = steps.turn_rad;
  EvaluatedPlacement best = map_all(start, seed);
  for (int level = 0; level < steps.levels; ++level, shift_m /= 2, turn_rad /= 2) {
    if (level > 0) {
      EvaluatedPlacement anew = map_all(best.candidate.pose, math::seed_from(seed, "again", level));
      if (anew.candidate.cost < best.candidate.cost) best = std::move(anew);
    }
    bool improved = true;
    for (int round = 0; improved && round < kMaxRounds; ++round) {
      improved = false;
      for (int direction = 0; direction < 6; ++direction) {
        for (const double sign : {1.0, -1.0}) {
          const BasePlacement next = project_to_constraints(
              take_step(best.candidate.pose, direction, sign * shift_m, sign * turn_rad),
              configured, options);
          if (is_same_placement(next, best.candidate.pose) ||
              !is_base_allowed(trials, next, robot_shoulder, planner.robot.side, options))
            continue;
          EvaluatedPlacement evaluated = map_all_from_warm(planner, next, trials, best);
          if (evaluated.candidate.cost > best.candidate.cost - kMinGain_deg) continue;
          best = std::move(evaluated);
          improved = true;
          break;
        }
      }
    }
  }
  return best.candidate;
}

}  // namespace morphe::place
