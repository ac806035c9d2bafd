#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::study {

/// The measures of a hand path in comparison with the human's, as a user of hands alone would judge
/// it.
struct HandScores {
  /// Distance of the tips from their goals, mean and 95th percentile [m].
  double tip_mean_m = kUnknown, tip_95_m = kUnknown;
  /// |thumb-index distance - the human's| in pinches, median [m].
  double pinch_median_m = kUnknown;
  /// Number of frames in pinches.
  std::size_t pinches = 0;
  /// Correlation of the thumb-index distance with the human's, over all frames.
  double correlation = kUnknown;
  /// Largest step of any joint [rad per 10 ms].
  double max_step_rad = 0;
  /// Rms acceleration of the tips divided by that of their goals.
  double acceleration = kUnknown;
  /// Share of frames in which the capsules of two links overlap.
  double overlap_share = 0;
  /// Largest overlap [m].
  double max_overlap_m = 0;
};

/// The result of a method on a recording: tips and goals [F][tips] in one frame.
struct HandPath {
  /// The time of each frame [s].
  std::vector<double> time;
  /// The joint positions [F, n].
  JointRows q;
  /// Goals of the method for its tips, NaN if a tip has no goal.
  std::vector<std::vector<Vec3>> goals;
  /// The human's own fingertips.
  std::vector<std::vector<Vec3>> human;
};

/// Computes the measures of a path. Frames in which the human's thumb-index distance is below
/// `near_m` are pinches.
HandScores score_hand(const robot::Robot& robot, const HandPath& course, double near_m);

}  // namespace morphe::study
