#include "pipeline/place/refine.hpp"

#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/place/reachability_grid.hpp"

namespace morphe::place {
namespace {

const SearchEffort kRefinementEffort{10, 2, 6};

/// A placement with the postures from which its cost was computed.
struct EvaluatedPlacement {
  Candidate candidate;
  std::vector<JointRows> q;  ///< [trials]
};

EvaluatedPlacement evaluate(const BasePlacement& stand, std::vector<TrialMapping> tried) {
  EvaluatedPlacement visit;
  std::vector<PlacementMeasures> all;
  for (TrialMapping& one : tried) {
    all.push_back(one.measures);
    visit.q.push_back(std::move(one.q));
  }
  const PlacementMeasures mean = mean_of(all);
  visit.candidate = {stand, mean, cost_of(mean)};
  return visit;
}

EvaluatedPlacement map_all_from_random(const planning::PlanningInputs& planner,
                                       const BasePlacement& stand,
                                       const std::vector<TrialMovement>& trials,
                                       std::uint64_t seed) {
  std::vector<TrialMapping> tried;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    tried.push_back(map_from_random_starts(planner, stand, trials[k], kRefinementEffort,
                                           math::seed_from(seed, "trial", k)));
  }
  return evaluate(stand, std::move(tried));
}

EvaluatedPlacement map_all_from_warm(const planning::PlanningInputs& planner,
                                     const BasePlacement& stand,
                                     const std::vector<TrialMovement>& trials,
                                     const EvaluatedPlacement& from) {
  std::vector<TrialMapping> tried;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    tried.push_back(map_from_warm_start(planner, stand, trials[k], kRefinementEffort, from.q[k]));
  }
  return evaluate(stand, std::move(tried));
}

/// Applies a step in one of six directions: shifts, then turns about the world's axes through the
/// shoulder.
BasePlacement take_step(const BasePlacement& stand, int way, double shift_m, double turn_rad) {
  BasePlacement next = stand;
  const Vec3 axis = Vec3::Unit(way % 3);
  if (way < 3) {
    next.shoulder_offset += shift_m * axis;
  } else {
    next.world_from_base =
        (Quat(Eigen::AngleAxisd(turn_rad, axis)) * stand.world_from_base).normalized();
  }
  return next;
}

bool is_same_placement(const BasePlacement& a, const BasePlacement& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < 1e-6 &&
         angle_between(a.world_from_base, b.world_from_base) < 1e-6;
}

}  // namespace

Candidate evaluate_placement(const planning::PlanningInputs& planner, const BasePlacement& stand,
                             const std::vector<const TrialMovement*>& trials,
                             const SearchEffort& effort, std::uint64_t seed) {
  std::vector<PlacementMeasures> all;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    all.push_back(map_from_random_starts(planner, stand, *trials[k], effort,
                                         math::seed_from(seed, "trial", k))
                      .measures);
  }
  const PlacementMeasures mean = mean_of(all);
  return {stand, mean, cost_of(mean)};
}

Candidate refine(const planning::PlanningInputs& planner, const BasePlacement& start,
                 const CompassSteps& steps, const BasePlacement& configured,
                 const std::vector<TrialMovement>& trials, const Vec3& robot_shoulder,
                 const PlaceOptions& options, std::uint64_t seed) {
  constexpr int kMaxRounds = 4;
  constexpr double kMinGain_deg = 0.02;  // smaller gains are ignored
  double shift_m = steps.shift_m, turn_rad = steps.turn_rad;
  EvaluatedPlacement best = map_all_from_random(planner, start, trials, seed);
  for (int level = 0; level < steps.levels; ++level, shift_m /= 2, turn_rad /= 2) {
    if (level > 0) {
      const std::uint64_t again = math::seed_from(seed, "again", level);
      EvaluatedPlacement anew = map_all_from_random(planner, best.candidate.stand, trials, again);
      if (anew.candidate.cost < best.candidate.cost) best = std::move(anew);
    }
    bool gained = true;
    for (int round = 0; gained && round < kMaxRounds; ++round) {
      gained = false;
      for (int way = 0; way < 6; ++way) {
        for (const double sign : {1.0, -1.0}) {
          const BasePlacement next = project_to_constraints(
              take_step(best.candidate.stand, way, sign * shift_m, sign * turn_rad), configured,
              options);
          if (is_same_placement(next, best.candidate.stand) ||
              !is_base_allowed(trials, next, robot_shoulder, planner.robot.side, options)) {
            continue;
          }
          EvaluatedPlacement there = map_all_from_warm(planner, next, trials, best);
          if (there.candidate.cost > best.candidate.cost - kMinGain_deg) continue;
          best = std::move(there);
          gained = true;
          break;
        }
      }
    }
  }
  return best.candidate;
}

}  // namespace morphe::place
