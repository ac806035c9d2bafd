#pragma once

#include "stages/place/score.hpp"

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

/// A compass search over shift and turn about the world's axes: along each of the six as far as it
/// gains, in steps of 0.12 m and 24 degrees, then half of that, three times. Postures are followed
/// from those of the last place that gained; after each halving they are searched for anew. Never
/// worse than `start`, and always allowed.
Candidate refine(const planning::Planner& planner, const Candidate& start, const Stand& configured,
                 const std::vector<Trial>& trials, const Vec3& robot_shoulder,
                 const PlaceOptions& options, std::uint64_t seed);

}  // namespace morphe::place
