#include "stages/map/mapping_problem.hpp"

#include <cassert>

namespace morphe::map {

void add_frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                         MappingScratch& scratch, solve::Quadratic& model,
                         humanlike::Curvature curvature) {
  humanlike::add_objective(problem.objective, *problem.robot, q, problem.goals[frame], scratch,
                           model, curvature);
  assert(problem.world->robot == problem.robot);
  std::vector<Pose>& poses = scratch.clearance.collision.base_from_frame;
  poses.swap(scratch.base_from_frame);  // lent to the clearance term and returned
  add_clearance(problem.clearance, *problem.world, problem.time[frame], scratch.clearance, model);
  poses.swap(scratch.base_from_frame);
}

}  // namespace morphe::map
