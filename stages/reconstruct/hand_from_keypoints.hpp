#pragma once

#include <optional>
#include <vector>

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/hand_shape.hpp"

namespace morphe::reconstruct {

/// A hand of constant bones, frame by frame, in the hand frame.
struct FittedHand {
  Table<Vec3> joints;  ///< [N, 21] nearest to the points
  JointRows angles;    ///< [N, 20] kHandAngleNames that come nearest to the joints
  HandBones bones;
  Table<Quat> tip_orientation;  ///< [N, 5] z along the last bone, x out of the pad
  bool thumb_base_estimated = false;
  /// "keypoints, bones constant": points from joints; "hand angles, thumb" …: joints from where
  /// the angles have them. Hinges of a model need not be those of this hand.
  std::vector<Residual> residuals;
};

/// Bones and knuckles are the medians of the points; with a hand length all points are scaled to
/// it first. The hand is turned about its wrist to fit its knuckles (fit_palm), its fingers follow
/// the points bone by bone (keep_bones), its angles follow those (HandFit). A thumb's base that was
/// never seen is estimated (median_hand); nothing if another point was never seen.
std::optional<FittedHand> fit_hand(const std::vector<HandKeypoints>& frames,
                                   const std::optional<double>& hand_length, double rate_hz);

/// Hand angles and residuals of a fitted hand become those of the motion; an estimated base of the
/// thumb is named in `estimated` and `problems`.
void take_angles(const FittedHand& fitted, HumanMotion& motion);

/// Fills hand angles and residuals from 21 keypoints; with the wrist's pose also tips, their
/// orientation and the fingers' joints. Only the points' shape counts, not where they are.
void add_hand_from_keypoints(const HandStream& keypoints, const std::optional<double>& hand_length,
                             const Clock& clock, const ReconstructOptions& options,
                             HumanMotion& motion);

}  // namespace morphe::reconstruct
