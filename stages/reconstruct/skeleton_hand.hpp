#pragma once

#include <vector>

#include "stages/reconstruct/clock.hpp"
#include "stages/reconstruct/hand_shape.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"

namespace morphe::reconstruct {

/// Orientations of the hand on the clock: those of a joint `hand` that has HumanMotion's axes, else
/// the wrist's turned by where the knuckles are on average, else from knuckles frame by frame.
/// Unseen where the skeleton's hand does not show them; what it was told by goes into `problems`.
std::vector<Quat> hand_orientation(const std::vector<double>& time, const SkeletonJoint& hand,
                                   const SkeletonJoint& wrist, const Digits& digits,
                                   const Clock& clock, const ReconstructOptions& options,
                                   HumanMotion& motion);

/// Puts tips that stand on the joint before them where a last bone of usual length, straight at
/// rest, would end: along the bone before it, turned as the last joint is.
void estimate_tips(Digits& digits, HumanMotion& motion);

/// Joints of the fingers on the clock: from the wrist on, each bone has its length and the
/// direction that was recorded; a joint is where it was if the one before it is missing. Unseen
/// where the skeleton has no such joint.
std::vector<HandKeypoints> fingers_on_clock(const std::vector<double>& time,
                                            const SkeletonJoint& wrist, const Digits& digits,
                                            const Clock& clock, const ReconstructOptions& options,
                                            const HumanMotion& motion);

}  // namespace morphe::reconstruct
