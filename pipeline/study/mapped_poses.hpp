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
  double tip_position = 1e5, tip_orientation = 1, humanlike = 1;
};

/// Returns goals for the robot's tips and elbow in the robot's base frame. `base_from_shoulder`
/// transforms human poses into that frame. Elbows are shifted in addition by the common base
/// offset. A tip without a finger follows the wrist's pose; a tip of a finger the position of that
/// fingertip, or the point on the curve through the fingertips at its finger_curve_share.
std::vector<humanlike::FrameGoal> goals_of(const robot::Robot& robot, const HumanPoses& poses,
                                           const Pose& base_from_shoulder);

/// The posture and its measures in each frame, [F] each. Errors are means over the tips of a frame.
struct MappedPoses {
  std::vector<JointVector> q;
  std::vector<double> position_m, orientation_rad;  ///< errors (full angle), NaN without a goal
  std::vector<double> humanlike_m2;                 ///< metric A, the mean over the joint centres
  std::vector<double> objective;                    ///< F; empty from measure_poses()
  double seconds = 0;                               ///< total duration of the warm-started solves
  int solves = 0;                                   ///< number of warm-started solves
  /// Appends the frames of `other`.
  void append(MappedPoses&& other);
};

/// Minimises F in every frame. In the first, the middle and the last frame, up to four minima are
/// found from `starts` random postures each. Each minimum is followed through the series in both
/// directions, and the best posture of each frame is returned.
MappedPoses map_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                      const StudyWeights& weights, const solve::MinimiseOptions& options,
                      int starts, std::uint64_t seed);

/// Computes the errors and metric A of postures that were found by another method.
MappedPoses measure_poses(const robot::Robot& robot, const std::vector<humanlike::FrameGoal>& goals,
                          const std::vector<JointVector>& q);

}  // namespace morphe::study
