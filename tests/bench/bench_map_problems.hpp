#pragma once

#include <string>
#include <vector>

#include "core/humanlike/frame_objective.hpp"

namespace morphe {

/// What bench_map solves: 90 Hz goals of reach-to-grasps, one movement after the other.
struct BenchProblem {
  std::string name;
  robot::Robot robot;
  humanlike::FrameObjective objective;
  std::vector<std::vector<humanlike::FrameGoal>> movements;
  std::vector<JointVector> begin;  ///< the position that made each movement's first goals
};

struct BenchGoals {
  bool orientations = false;
  /// Of an electromagnetic tracker and a glove, white in every frame: 0.76 mm and 0.15 degrees of
  /// the wrist and elbow, 1 degree of every finger joint.
  bool noise = false;
};

/// The goals are what the robot's own tips do when its joints move by minimum jerk for one second
/// between two random positions, so that without noise each can be met. The human's elbow lies in
/// the direction of the robot's first centre, 0.323 m off the shoulder.
BenchProblem make_bench_problem(const std::string& name, const robot::Robot& robot,
                                const BenchGoals& goals);

}  // namespace morphe
