#include "stages/map/reachable.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "pipeline/kinematics/draw_tips.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe {
namespace {

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
  constexpr int kDrawn = 12;           // steps
  constexpr double kSameValue = 1e-4;  // relative
  constexpr int kOftenEnough = 8;      // descents that end in the least value: it is the least
  DrawScratch draw;
  const auto reached = [&](JointVector q, int steps) {
    return draw_tips(*problem.robot, problem.goals[frame].tip_position, steps, tolerance_m, q,
                     draw) <= tolerance_m;
  };
  // From a mapped posture tips are nearly always drawn to their goals, at a fraction of a solve.
  if (reached(near, kDrawn)) return true;
  const MappingProblem plain = tips_alone(problem, frame);
  MinimiseOptions as_exact = options;
  as_exact.relative_value = std::max(options.relative_value, 1e-4 * kSameValue);
  std::mt19937_64 random(seed);
  double least = std::numeric_limits<double>::infinity();
  int ended_there = 0;
  for (int i = 0; i <= starts && ended_there < kOftenEnough; ++i) {
    const JointVector start = i == 0 ? near : random_start(*problem.robot, random);
    const Minimum found = solve_frame(plain, 0, start, as_exact, scratch);
    if (reached(found.x, 0)) return true;
    if (found.value < (1 - kSameValue) * least) ended_there = 0;
    if (found.value < (1 + kSameValue) * least) ++ended_there;
    least = std::min(least, found.value);
  }
  return false;
}

}  // namespace morphe
