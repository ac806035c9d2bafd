#pragma once

#include <vector>

#include "stages/reconstruct/hand_shape.hpp"
#include "stages/reconstruct/skeleton_joints.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// Computes the orientation of the hand on the clock: that of a joint `hand` with HumanMotion's
/// axes, otherwise the wrist's corrected by the mean position of the knuckles, otherwise from the
/// knuckles frame by frame. Unseen if the skeleton's hand does not have them; missing points are
/// reported in `motion.reconstruction_notes`.
std::vector<Quat> hand_orientation(const std::vector<double>& time, const SkeletonJoint& hand,
                                   const SkeletonJoint& wrist, const Digits& digits,
                                   const TimeGrid& clock, const ReconstructOptions& options,
                                   HumanMotion& motion);

/// Estimates tips that coincide with the joint before them: they are placed at the end of a last
/// bone of average length along the bone before it at rest, turned as the last joint is.
void estimate_tips(Digits& digits, HumanMotion& motion);

/// Resamples the joints of the fingers on the clock: from the wrist on, each bone has its constant
/// length and the recorded direction; a joint keeps its recorded position if the previous one is
/// missing. Unseen if the skeleton has no such joint.
std::vector<HandKeypoints> resample_fingers(const std::vector<double>& time,
                                            const SkeletonJoint& wrist, const Digits& digits,
                                            const TimeGrid& clock,
                                            const ReconstructOptions& options,
                                            const HumanMotion& motion);

}  // namespace morphe::reconstruct
