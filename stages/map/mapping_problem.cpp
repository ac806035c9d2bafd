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

double frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                       MappingScratch& scratch) {
  scratch.model.reset(q.size());
  add_frame_objective(problem, frame, q, scratch, scratch.model, humanlike::Curvature::none);
  return scratch.model.value;
}

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

JointVector random_start(const RobotModel& robot, std::mt19937_64& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    q[j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
  }
  return q;
}

}  // namespace morphe::map
