#pragma once

#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::study {

/// A hand's course beside the human's: what a user of hands alone looks at.
struct HandScores {
  double tip_mean_m = kNotSeen, tip_95_m = kNotSeen;  ///< from where the method wants its tips
  double pinch_median_m = kNotSeen;                   ///< |thumb-index - the human's| in pinches
  std::size_t pinches = 0;                            ///< frames
  double correlation = kNotSeen;   ///< thumb-index distance with the human's, all frames
  double largest_step_rad = 0;     ///< of any joint, per 10 ms
  double acceleration = kNotSeen;  ///< rms of tips', robot's over that of their goals
  double overlapping = 0;          ///< share of frames in which capsules of two links overlap
  double deepest_m = 0;            ///< by how much, at most
};

/// What a method makes of a recording: tips and goals [F][tips] in one frame.
struct HandCourse {
  std::vector<double> time;
  JointRows q;
  std::vector<std::vector<Vec3>> goals;  ///< where the method wants its tips, NaN = nowhere
  std::vector<std::vector<Vec3>> human;  ///< the human's own tips
};

HandScores score_hand(const robot::Robot& robot, const HandCourse& course, double near_m);

}  // namespace morphe::study
