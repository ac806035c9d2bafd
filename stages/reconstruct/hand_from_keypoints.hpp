#pragma once

#include <optional>
#include <vector>

#include "stages/reconstruct/hand_shape.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// A hand with constant bone lengths, fitted frame by frame in the hand frame.
struct FittedHand {
  Array2D<Vec3> joints;               ///< [N, 21] joints nearest to the points
  JointRows angles;                   ///< [N, 20] angles (kHandAngleNames) nearest to the joints
  HandBones bones;                    ///< lengths of the fingers and positions of the knuckles
  Array2D<Quat> tip_orientation;      ///< [N, 5] z along the last bone, x out of the pad
  bool thumb_base_estimated = false;  ///< true if it was never seen
  /// "keypoints, bones constant": distances of keypoints from `joints`; "hand angles, thumb" and so
  /// on: distances of `joints` from those that `angles` give in a hand model with other hinges.
  std::vector<Residual> residuals;
};

/// Fits a hand with constant bone lengths to keypoints [m] at `rate_hz`, in any fixed axes. Bones
/// and knuckles are medians over the frames, scaled to `hand_length` [m] if given. In each frame,
/// the hand rotates about its wrist to fit its knuckles (fit_palm), its fingers follow the points
/// bone by bone (enforce_finger_lengths), and its angles follow the fingers (FingerIkSolver). A
/// thumb base that was never seen is estimated (estimate_hand_shape). Returns nullopt if another
/// point was never seen.
std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length, double rate_hz);

/// Adds the angles and residuals of a fitted hand, and notes an estimated base of the thumb.
void add_hand_angles(const FittedHand& fitted, HumanMotion& motion);

/// Sets tips and middle joints of the fingers to keypoints in the world, one per frame.
void set_finger_points(const std::vector<HandKeypoints>& frames, HumanMotion& motion);

/// Sets the orientations of the tips: the fitted ones, rotated by the wrist's orientation.
void set_tip_orientations(const FittedHand& fitted, HumanMotion& motion);

/// Adds hand angles and residuals from 21 keypoints; with the wrist's pose also tips, their
/// orientation and the fingers' joints. Only the shape of the points matters, not their position.
void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const TimeGrid& clock, const ReconstructOptions& options,
                             HumanMotion& motion);

}  // namespace morphe::reconstruct
