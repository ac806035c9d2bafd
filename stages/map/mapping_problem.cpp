#include "stages/map/mapping_problem.hpp"

#include <cmath>

namespace morphe {

void add_frame(const MappingProblem& problem, std::size_t frame, const JointVector& q,
               MappingScratch& scratch, Quadratic& model) {
  add_objective(problem.objective, *problem.robot, q, problem.goals[frame], scratch.base_from_frame,
                model);
  add_clearance(problem.clearance, *problem.world, q, problem.time[frame], scratch.clearance,
                model);
}

double mean_step(const std::vector<double>& time) {
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

JointVector third_difference_weight(const RobotTable& robot, const std::vector<double>& time,
                                    double smoothness) {
  const double step_s = mean_step(time);
  const JointVector jerk_share = (robot.jerk * std::pow(step_s, 3)).cwiseInverse();
  return smoothness * (step_s / kReferenceStep) * jerk_share.cwiseAbs2();
}

}  // namespace morphe
