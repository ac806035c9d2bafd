#pragma once

#include "pipeline/place/score.hpp"

namespace morphe::place {

/// A placement and what it is worth over the trials.
struct Candidate {
  Stand stand;
  Measures measures;
  double cost = 0;
};

/// Mean over the trials by search from random starts.
Candidate try_stand(const planning::Planner& planner, const Stand& stand,
                    const std::vector<const Trial*>& trials, const Effort& effort,
                    std::uint64_t seed);

/// Of a compass search: the first step, and how often it is halved.
struct Steps {
  double shift_m = 0.12, turn_rad = 24 * kDegree;
  int levels = 4;
};

/// A compass search over shift and turn about the world's axes: along each of the six as far as it
/// gains, at each level with half the steps of the one before. Postures are followed from those of
/// the last place that gained; at each level they are searched for anew. Always allowed; never
/// worse than what the search finds at `start`.
Candidate refine(const planning::Planner& planner, const Stand& start, const Steps& steps,
                 const Stand& configured, const std::vector<Trial>& trials,
                 const Vec3& robot_shoulder, const PlaceOptions& options, std::uint64_t seed);

}  // namespace morphe::place
