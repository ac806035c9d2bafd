#include "stages/map/nearest_errors.hpp"

#include "core/robot/forward_kinematics.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/reachability.hpp"

namespace morphe::map {

JointRows nearest_errors(const MappingProblem& problem, const JointRows& path,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver) {
  solve::MinimiseOptions options = solver;
  options.relative_tolerance = std::max(options.relative_tolerance, kNearestErrorTolerance);
  const std::ptrdiff_t tips = std::ssize(problem.robot->tips);
  JointRows errors = JointRows::Constant(path.rows(), tips, kUnknown);
  MappingScratch scratch;
  std::vector<Pose> base_from_frame;
  JointVector previous_solution;
  for (int f = 0; f < path.rows(); ++f) {
    const humanlike::FrameGoal& goal = problem.goals[f];
    if (reachable[f] || goal.goal_tip_count() == 0) {
      previous_solution.resize(0);
      continue;
    }
    const MappingProblem tips_only = tip_position_problem(problem, f);
    solve::Minimum best = solve_frame(tips_only, 0, path.row(f).transpose(), options, scratch);
    if (previous_solution.size() > 0) {
      solve::Minimum other = solve_frame(tips_only, 0, previous_solution, options, scratch);
      if (other.value < best.value) best = std::move(other);
    }
    previous_solution = best.x;
    robot::forward_kinematics(*problem.robot, best.x, base_from_frame);
    for (int tip = 0; tip < tips; ++tip) {
      if (!is_known(goal.tip_position[tip])) continue;
      const Vec3 reached =
          robot::tracked_point(*problem.robot, base_from_frame, tip, goal.tip_to_pad_share_of(tip));
      errors(f, tip) = (reached - goal.tip_position[tip]).norm();
    }
  }
  return errors;
}

}  // namespace morphe::map
