#include "stages/map/reachable.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "pipeline/kinematics/draw_tips.hpp"
#include "pipeline/kinematics/forward.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe {
namespace {

/// Largest distance of a tip from its goal; 0 without goals.
double tip_error(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                 MappingScratch& scratch) {
  const FrameGoal& goal = problem.goals[frame];
  double largest = 0;
  forward(*problem.robot, q, scratch.base_from_frame);
  for (std::size_t i = 0; i < goal.tip_position.size(); ++i) {
    if (!seen(goal.tip_position[i])) continue;
    const Pose tip = tip_pose(*problem.robot, scratch.base_from_frame, i);
    largest = std::max(largest, (tip.translation() - goal.tip_position[i]).norm());
  }
  return largest;
}

/// The frame by itself, with nothing to ask but tip positions.
MappingProblem tips_alone(const MappingProblem& problem, std::size_t frame) {
  MappingProblem plain = on_frames(problem, {frame});
  plain.clearance.weight = 0;
  plain.objective = {};
  plain.objective.tip_position = problem.objective.tip_position;
  plain.objective.tip_orientation.weight = 0;
  plain.objective.hand_orientation.weight = 0;
  plain.objective.joint_distance.weight = 0;
  plain.objective.finger_joint_distance.weight = 0;
  return plain;
}

}  // namespace

bool goals_reachable(const MappingProblem& problem, std::size_t frame, const JointVector& near,
                     int starts, double tolerance_m, const MinimiseOptions& options,
                     std::uint64_t seed, MappingScratch& scratch) {
  constexpr int kDrawn = 12;
  constexpr double kSameValue = 1e-4;  // relative
  constexpr int kOftenEnough = 8;      // descents that end in the least value: it is the least
  // From a mapped posture tips are nearly always drawn to their goals, at a fraction of a solve.
  const std::vector<Vec3>& places = problem.goals[frame].tip_position;
  JointVector drawn = near;
  if (draw_tips(*problem.robot, places, kDrawn, tolerance_m, drawn, scratch.draw) <= tolerance_m) {
    return true;
  }
  const MappingProblem plain = tips_alone(problem, frame);
  MinimiseOptions as_exact = options;
  as_exact.relative_value = std::max(options.relative_value, 1e-4 * kSameValue);
  std::mt19937_64 random(seed);
  double least = std::numeric_limits<double>::infinity();
  int ended_there = 0;
  for (int i = 0; i <= starts && ended_there < kOftenEnough; ++i) {
    const JointVector start = i == 0 ? near : random_start(*problem.robot, random);
    const Minimum found = solve_frame(plain, 0, start, as_exact, scratch);
    if (tip_error(plain, 0, found.x, scratch) <= tolerance_m) return true;
    if (found.value < (1 - kSameValue) * least) ended_there = 0;
    if (found.value < (1 + kSameValue) * least) ++ended_there;
    least = std::min(least, found.value);
  }
  return false;
}

}  // namespace morphe
