#pragma once

#include <vector>

#include "stages/reconstruct/hand_shape.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// Returns the orientation of the hand on the clock. It is that of `hand` if recorded; otherwise
/// the wrist's, corrected by the mean position of the knuckles; otherwise that of the knuckles,
/// frame by frame. It is unseen if the skeleton has too few knuckles, which is noted in `motion`.
std::vector<Quat> hand_orientation(const std::vector<double>& time, const SkeletonJoint& hand,
                                   const SkeletonJoint& wrist, const Digits& digits,
                                   const TimeGrid& clock, const ReconstructOptions& options,
                                   HumanMotion& motion);

/// Estimates tips that coincide with the last joint. The last bone gets the length that an average
/// hand has in proportion to the bone before it, and the mean direction of that bone in the axes of
/// the middle joint, rotated by the orientation of the last joint.
void estimate_tips(Digits& digits, HumanMotion& motion);

/// Returns the joints of the fingers on the clock. From the wrist of `motion` on, each bone has its
/// mean length and the recorded direction. A joint after a missing one stays as recorded; a missing
/// one is unseen.
std::vector<HandKeypoints> resample_fingers(const std::vector<double>& time,
                                            const SkeletonJoint& wrist, const Digits& digits,
                                            const TimeGrid& clock,
                                            const ReconstructOptions& options,
                                            const HumanMotion& motion);

}  // namespace morphe::reconstruct
