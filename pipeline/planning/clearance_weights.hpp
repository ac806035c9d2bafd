#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// The weights of clearance and tips in a re-solve, relative to those of the mapping.
struct ClearanceWeights {
  double clearance = 1;  ///< weight of the clearance term
  /// scale of the clearance band; below 1, only freedom from collision is required
  double band_scale = 1;
  double tips = 1;  ///< weight of the tip positions
};

/// Weights with which tips and clearance alone determine the result, to a tenth of a millimetre.
constexpr ClearanceWeights kStrongestWeights{30000, 0.2, 30};

/// Returns the mapping problem with modified weights.
map::MappingProblem with_clearance_weights(map::MappingProblem problem,
                                           const ClearanceWeights& firmness);

}  // namespace morphe::planning
