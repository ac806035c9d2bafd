#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::study {

/// The measures of a path of a hand without an arm, in comparison with the human's hand.
struct HandScores {
  double tip_mean_m = kUnknown, tip_95_m = kUnknown;  ///< tip error, mean and 95th percentile
  double pinch_median_m = kUnknown;  ///< median of |robot's - human's thumb-index distance|
  int pinches = 0;                   ///< number of frames in pinches
  double correlation = kUnknown;     ///< of the thumb-index distance with the human's
  double max_step_rad = 0;           ///< largest step of any joint [rad per 10 ms]
  double acceleration = kUnknown;  ///< rms acceleration of the tips divided by that of their goals
  double overlap_share = 0;        ///< share of frames in which the capsules of two links overlap
  double max_overlap_m = 0;        ///< largest overlap [m]
};

/// The path of a method for a recording. Points are given as [F][tips]; those of `goals` are in the
/// robot's base frame, those of `human` in any fixed frame, since only their distances are used.
struct HandPath {
  std::vector<double> time;
  JointRows q;                           ///< joint positions [F, n]
  std::vector<std::vector<Vec3>> goals;  ///< goals of the method for its tips, NaN without a goal
  std::vector<std::vector<Vec3>> human;  ///< the human's own fingertips
};

/// Computes the measures of a path. Frames in which the human's thumb-index distance is below
/// `pinch_distance_m` are pinches.
HandScores score_hand(const robot::Robot& robot, const HandPath& path, double pinch_distance_m);

}  // namespace morphe::study
