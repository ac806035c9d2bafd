#pragma once

#include <cstdint>
#include <vector>

#include "core/humanlike/frame_objective.hpp"
#include "core/solve/minimise.hpp"
#include "pipeline/study/human_poses.hpp"

namespace morphe::study {

/// Weights of a study: tip position [1/m²], tip orientation (half the angle) [1/rad], metric A of
/// the arm as its mean over the joint centres [1/m²].
struct StudyWeights {
  double tip_position = 1e5, tip_orientation = 1, humanlike = 1;
};

/// What the robot's tips and elbow shall reach: goals in the robot's base frame.
/// `base_from_shoulder` carries human poses there; elbows are shifted on, so that the human's
/// shoulder is the robot's (the common base frame). Robots with a wrist as end-effector get its
/// pose, those with fingers the fingertips' positions (by the rule for m fingers).
std::vector<humanlike::FrameGoal> goals_of(const robot::Robot& robot, const HumanPoses& poses,
                                           const Pose& base_from_shoulder);

/// Frames solved one by one. [F] each; errors are means over the frame's tips.
struct MappedPoses {
  std::vector<JointVector> q;
  std::vector<double> position_m, orientation_rad;  ///< the full angle; NaN without such a goal
  std::vector<double> humanlike_m2;                 ///< A, the mean over the centres
  std::vector<double> value;
  double seconds = 0;  ///< of the warm solves
  std::size_t solves = 0;
  void append(MappedPoses&& other);
};

/// The least of F in every frame over minima found from `starts` random positions in each of three
/// key frames and followed through the series both ways.
MappedPoses map_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                      const StudyWeights& weights, const solve::MinimiseOptions& options,
                      int starts, std::uint64_t seed);

/// Errors and A of postures that were found otherwise.
MappedPoses measure_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                          const std::vector<JointVector>& q);

}  // namespace morphe::study
