#pragma once

#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// How much a re-solve gives to freedom and to tips: times what the mapping gives them.
struct Firmness {
  double clearance = 1;   ///< the clearance term's weight
  double band_share = 1;  ///< of the band that it keeps; below 1 nothing more than freedom is asked
  double tips = 1;        ///< the weight of tip positions
};

/// Tips and freedom alone decide, to the last tenth of a millimetre.
constexpr Firmness kFirmest{30000, 0.2, 30};

map::MappingProblem as_firm(map::MappingProblem problem, const Firmness& firmness);

}  // namespace morphe::planning
