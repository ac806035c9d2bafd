#include "stages/map/make_movement_problem.hpp"

namespace morphe::map {

solve::MovementProblem make_movement_problem(const MappingProblem& problem,
                                             const MovementCost& cost,
                                             std::vector<MappingScratch>& scratch) {
  solve::MovementProblem movement;
  movement.frames = problem.frames();
  movement.lower = problem.robot->lower;
  movement.upper = problem.robot->upper;
  movement.difference_weight = difference_weights(*problem.robot, problem.time, cost);
  scratch.assign(problem.frames(), {});
  const double share = mean_step(problem.time) / kReferenceStep_s;
  movement.frame_model = [&, share](std::size_t frame, const JointVector& q,
                                    solve::Quadratic& model) {
    add_frame_objective(problem, frame, q, scratch[frame], model, humanlike::Curvature::exact);
    model.scale(share);
  };
  return movement;
}

}  // namespace morphe::map
