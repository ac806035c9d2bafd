#include "pipeline/planning/clearance_weights.hpp"

namespace morphe::planning {

map::MappingProblem with_clearance_weights(map::MappingProblem problem,
                                           const ClearanceWeights& factors) {
  problem.clearance.weight *= factors.clearance;
  problem.clearance.activation_distance_m *= factors.band_scale;
  problem.objective.get<humanlike::TipPosition>().weight *= factors.tips;
  return problem;
}

}  // namespace morphe::planning
