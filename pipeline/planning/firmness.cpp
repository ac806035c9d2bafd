#include "pipeline/planning/firmness.hpp"

namespace morphe::planning {

map::MappingProblem as_firm(map::MappingProblem problem, const Firmness& firmness) {
  problem.clearance.weight *= firmness.clearance;
  problem.clearance.band_m *= firmness.band_share;
  problem.objective.get<humanlike::TipPosition>().weight *= firmness.tips;
  return problem;
}

}  // namespace morphe::planning
