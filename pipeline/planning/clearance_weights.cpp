#include "pipeline/planning/clearance_weights.hpp"

namespace morphe::planning {

map::MappingProblem with_clearance_weights(map::MappingProblem problem,
                                           const ClearanceWeights& firmness) {
  problem.clearance.weight *= firmness.clearance;
  problem.clearance.activation_distance_m *= firmness.band_scale;
  problem.objective.get<humanlike::TipPosition>().weight *= firmness.tips;
  return problem;
}

}  // namespace morphe::planning
