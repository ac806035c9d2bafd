#pragma once

#include <optional>
#include <vector>

#include "stages/reconstruct/hand_shape.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// A hand with constant bone lengths, fitted frame by frame in the hand frame.
struct FittedHand {
  Array2D<Vec3> joints;               ///< [N, 21] joints nearest to the points
  JointRows angles;                   ///< [N, 20] angles (kHandAngleNames) nearest to the joints
  HandBones bones;                    ///< lengths and knuckles of the hand
  Array2D<Quat> tip_orientation;      ///< [N, 5] z along the last bone, x out of the pad
  bool thumb_base_estimated = false;  ///< true if it was never seen
  /// "keypoints, bones constant": distances of points from joints; "hand angles, thumb" …:
  /// distances of joints from those of the angles. The hinges of a model need not be those of this
  /// hand.
  std::vector<Residual> residuals;
};

/// Fits a hand with constant bone lengths to keypoints. Bones and knuckles are the medians of the
/// points; with a hand length all points are first scaled to it. The hand is turned about its wrist
/// to fit its knuckles (fit_palm), its fingers follow the points bone by bone
/// (enforce_finger_lengths), and its angles follow those (FingerIkSolver). The base of a thumb that
/// was never seen is estimated (estimate_hand_shape). Returns no hand if another point was never
/// seen.
std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length, double rate_hz);

/// Adds the hand angles and residuals of a fitted hand to a motion. An estimated base of the thumb
/// is named in `estimated` and `reconstruction_notes`.
void add_hand_angles(const FittedHand& fitted, HumanMotion& motion);

/// Adds hand angles and residuals from 21 keypoints; with the wrist's pose also tips, their
/// orientation and the fingers' joints. Only the shape of the points matters, not their position.
void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const TimeGrid& clock, const ReconstructOptions& options,
                             HumanMotion& motion);

}  // namespace morphe::reconstruct
