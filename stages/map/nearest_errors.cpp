#include "stages/map/nearest_errors.hpp"

#include "core/robot/forward_kinematics.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/reachability.hpp"

namespace morphe::map {

using Eigen::Index;

JointRows nearest_errors(const MappingProblem& problem, const JointRows& near,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver) {
  constexpr double kRelativeTolerance = 1e-6;  // relative, sufficient for a reported value
  solve::MinimiseOptions options = solver;
  options.relative_tolerance = std::max(options.relative_tolerance, kRelativeTolerance);
  const auto tips = static_cast<Index>(problem.robot->tips.size());
  JointRows errors = JointRows::Constant(near.rows(), tips, kUnknown);
  MappingScratch scratch;
  std::vector<Pose> base_from_frame;
  JointVector before;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const humanlike::FrameGoal& goal = problem.goals[f];
    if (reachable[f] || goal.goal_tip_count() == 0) {
      before.resize(0);
      continue;
    }
    const auto row = static_cast<Index>(f);
    const MappingProblem plain = tip_position_problem(problem, f);
    solve::Minimum best = solve_frame(plain, 0, near.row(row).transpose(), options, scratch);
    if (before.size() > 0) {
      solve::Minimum other = solve_frame(plain, 0, before, options, scratch);
      if (other.value < best.value) best = std::move(other);
    }
    before = best.x;
    robot::forward_kinematics(*problem.robot, best.x, base_from_frame);
    for (Index i = 0; i < tips; ++i) {
      const auto tip = static_cast<std::size_t>(i);
      if (!is_known(goal.tip_position[tip])) continue;
      const Vec3 at =
          robot::tracked_point(*problem.robot, base_from_frame, tip, goal.tip_to_pad_share_of(tip));
      errors(row, i) = (at - goal.tip_position[tip]).norm();
    }
  }
  return errors;
}

}  // namespace morphe::map
