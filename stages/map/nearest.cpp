#include "stages/map/nearest.hpp"

#include "core/robot/forward.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/reachable.hpp"

namespace morphe::map {

using Eigen::Index;

JointRows nearest_errors(const MappingProblem& problem, const JointRows& near,
                         const std::vector<bool>& reachable, const solve::MinimiseOptions& solver) {
  constexpr double kExact = 1e-6;  // relative, of a figure to be read
  solve::MinimiseOptions options = solver;
  options.relative_value = std::max(options.relative_value, kExact);
  const auto tips = static_cast<Index>(problem.robot->tips.size());
  JointRows errors = JointRows::Constant(near.rows(), tips, kNotSeen);
  MappingScratch scratch;
  std::vector<Pose> base_from_frame;
  JointVector before;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const humanlike::FrameGoal& goal = problem.goals[f];
    if (reachable[f] || goal.tips_seen() == 0) {
      before.resize(0);
      continue;
    }
    const auto row = static_cast<Index>(f);
    const MappingProblem plain = tips_alone(problem, f);
    solve::Minimum best = solve_frame(plain, 0, near.row(row).transpose(), options, scratch);
    if (before.size() > 0) {
      solve::Minimum other = solve_frame(plain, 0, before, options, scratch);
      if (other.value < best.value) best = std::move(other);
    }
    before = best.x;
    robot::forward(*problem.robot, best.x, base_from_frame);
    for (Index i = 0; i < tips; ++i) {
      const auto tip = static_cast<std::size_t>(i);
      if (!seen(goal.tip_position[tip])) continue;
      const Vec3 at =
          robot::goal_point(*problem.robot, base_from_frame, tip, goal.pad_share_of(tip));
      errors(row, i) = (at - goal.tip_position[tip]).norm();
    }
  }
  return errors;
}

}  // namespace morphe::map
