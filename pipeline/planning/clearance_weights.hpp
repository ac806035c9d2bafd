#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// The factors by which a re-solve changes the mapping's terms for clearance and tip positions.
struct ClearanceWeights {
  double clearance = 1;  ///< factor on the weight of the clearance term
  /// factor on the distance at which the clearance term begins; below 1, little more than freedom
  /// from collision is asked for
  double band_scale = 1;
  double tips = 1;  ///< factor on the weight of the tip positions
};

/// Returns the mapping problem with its terms changed by these factors.
map::MappingProblem with_clearance_weights(map::MappingProblem problem,
                                           const ClearanceWeights& factors);

}  // namespace morphe::planning
