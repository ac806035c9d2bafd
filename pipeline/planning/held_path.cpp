#include "pipeline/planning/held_path.hpp"

#include <vector>

#include "pipeline/planning/constants.hpp"
#include "stages/grasp/held_goals.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::planning {

void hold_joints(const grasp::HoldInterval& hold, const JointVector& held, double weight,
                 map::MappingProblem& problem) {
  problem.objective.get<humanlike::JointAngle>().weight = weight;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    if (grasp::is_held_at(hold, problem.time[f])) problem.goals[f].angles = held;
  }
}

void follow_target(const map::MappingProblem& problem, std::size_t grasp_frame,
                   const JointVector& held, const map::MapOptions& options, JointRows& path) {
  JointVector stay = JointVector::Zero(held.size());
  for (const int joint : problem.robot->arm_joints) stay[joint] = kHeldArmWeight;
  map::MappingScratch scratch;
  JointVector q = held;
  for (std::size_t f = grasp_frame; f < problem.frames(); ++f) {
    q = map::solve_frame_near(problem, f, q, stay, options.frame_solver, scratch).x;
    path.row(f) = q.transpose();
  }
}

}  // namespace morphe::planning
