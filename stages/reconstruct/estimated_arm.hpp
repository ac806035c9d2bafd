#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Upper arm and forearm: the recording's own, else the config's, else those of a stature: the
/// config's, else what a hand of that length (wrist to middle fingertip [m]) usually belongs to
/// (0.108 of the stature, Drillis and Contini 1966), else 1.70 m.
human::ArmLengths arm_lengths_of(const Demonstration& demonstration, const HumanOptions& human,
                                 const std::optional<double>& hand_length = {});

/// A right arm of which the wrist was seen, and perhaps the head [N], in the world (the person
/// faces Y). What of shoulder and elbow was never seen is filled in, and named in `estimated`:
///   shoulder  one place for the whole recording: below and beside the head where that was seen, by
///             shares of the stature (0.115 below, 0.129 - 0.02 aside: half of the biacromial
///             breadth, less the joint's depth); else `shoulder_from_first_wrist` from the first
///             wrist; then moved as little as it takes to reach every wrist
///   elbow     on the circle that the lengths leave, turned outward by `elbow_outward` (a swivel
///             sought for the hand's orientation within human limits is no nearer to the person's)
/// Hidden in the five ue-adl trials, shoulders are found within 48 to 65 mm RMS, elbows of reaches
/// within 51 and 62 mm, of drinking, which lifts them, within 120 to 181 mm; the upper arm points 5
/// and 9 degrees, or 19 to 32, elsewhere.
void estimate_arm(const human::ArmLengths& lengths, const HumanOptions& human,
                  const std::vector<Vec3>& head, HumanMotion& motion);

}  // namespace morphe::reconstruct
