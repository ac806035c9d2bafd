#pragma once

#include <cstdint>
#include <vector>

#include "core/humanlike/frame_objective.hpp"
#include "core/solve/minimise.hpp"
#include "pipeline/study/human_poses.hpp"

namespace morphe::study {

/// The weights of a study: tip position [1/m²], tip orientation (half the angle) [1/rad], and
/// metric A of the arm as its mean over the joint centres [1/m²].
struct StudyWeights {
  /// The weights, by default mostly on the tip position.
  double tip_position = 1e5, tip_orientation = 1, humanlike = 1;
};

/// Returns goals for the robot's tips and elbow in the robot's base frame. `base_from_shoulder`
/// transforms human poses into that frame; elbows are shifted in addition, so that the human's
/// shoulder coincides with the robot's (the common base frame). Robots with a wrist as end effector
/// follow the wrist's pose, those with fingers follow the positions of the fingertips (by the rule
/// for m fingers).
std::vector<humanlike::FrameGoal> goals_of(const robot::Robot& robot, const HumanPoses& poses,
                                           const Pose& base_from_shoulder);

/// Frames that were solved individually, [F] each. Errors are means over the tips of a frame.
struct MappedPoses {
  /// The joint positions.
  std::vector<JointVector> q;
  /// Position error [m] and full angle of the orientation error [rad], NaN if there is no such
  /// goal.
  std::vector<double> position_m, orientation_rad;
  /// Metric A, the mean over the joint centres [m²].
  std::vector<double> humanlike_m2;
  /// The value of the objective.
  std::vector<double> objective;
  /// Duration of the warm-started solves [s].
  double seconds = 0;
  /// The number of warm-started solves.
  std::size_t solves = 0;
  /// Appends the frames of `other`.
  void append(MappedPoses&& other);
};

/// Minimises F in every frame. The minima are found from `starts` random positions in each of three
/// key frames and followed through the series in both directions.
MappedPoses map_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                      const StudyWeights& weights, const solve::MinimiseOptions& options,
                      int starts, std::uint64_t seed);

/// Computes the errors and metric A of postures that were found by another method.
MappedPoses measure_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                          const std::vector<JointVector>& q);

}  // namespace morphe::study
