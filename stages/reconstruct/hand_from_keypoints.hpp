#pragma once

#include <optional>
#include <vector>

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe {

/// A hand on the clock as a hand of constant bones: the angles that come nearest.
struct FittedHand {
  double scale = 1;                 ///< what the points were multiplied by to have the hand length
  JointRows angles;                 ///< [N, 20] kHandAngleNames, NaN = unseen
  Table<Vec3> joints;               ///< [N, 21] of the fitted hand, in the hand frame
  Table<Quat> tip_orientation;      ///< [N, 5] in the hand frame
  std::vector<Residual> residuals;  ///< one a finger: points from where the fitted hand has them
};

/// Bones and knuckles are the medians of the points; with a hand length all points are scaled to
/// it first. The hand is turned about its wrist to fit its knuckles (fit_palm), the fingers bent to
/// fit the rest (HandFit). Nothing if a point was never seen.
std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length);

/// Fills hand angles and residuals from 21 keypoints; with the wrist's pose also tips, their
/// orientation and the fingers' joints. Only the points' shape counts, not where they are.
void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const Clock& clock, const ReconstructOptions& options,
                             HumanMotion& motion);

}  // namespace morphe
