#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

void add_frame(const MappingProblem& problem, std::size_t frame, const JointVector& q,
               MappingScratch& scratch, solve::Quadratic& model, humanlike::Curvature curvature) {
  humanlike::add_objective(problem.objective, *problem.robot, q, problem.goals[frame], scratch,
                           model, curvature);
  add_clearance(problem.clearance, *problem.world, q, problem.time[frame], scratch.clearance,
                model);
}

}  // namespace morphe::map
