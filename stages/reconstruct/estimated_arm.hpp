#pragma once

#include <optional>

#include "core/human/arm.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {

/// Returns the lengths of upper arm and forearm: the recording's, else those in `human`, else those
/// for a stature. The stature is that in `human`, else it follows from `hand_length` (wrist to
/// middle fingertip [m]), else it is kDefaultStature_m.
human::ArmLengths arm_lengths_of(const Demonstration& demonstration, const HumanOptions& human,
                                 const std::optional<double>& hand_length = {});

/// Estimates shoulder and elbow of a right arm if they were never seen, from the wrist and the head
/// ([N] in the world, or empty); the person faces Y. The estimates are named in `estimated`:
///   shoulder  a fixed position for the whole recording. It begins below and beside the median head
///             by shares of the stature (0.115 below, 0.129 - 0.02 aside: half of the biacromial
///             breadth less the joint's depth), or without a head at the first wrist plus
///             `shoulder_from_first_wrist`. It then moves as little as necessary to have every
///             wrist within `max_reach_share` of the arm's length; if it cannot, `motion` gets a
///             note and no estimate.
///   elbow     on the circle determined by the lengths, at the swivel angle `elbow_swivel` (one
///             optimised for the hand's orientation within human limits is no nearer)
/// Errors in the five ue-adl trials, RMS: shoulder 48 to 65 mm; in reaches, elbow 51 and 62 mm and
/// direction of the upper arm 5 and 9 degrees; in drinking, which lifts the elbow, 120 to 181 mm
/// and 19 to 32 degrees.
void estimate_arm(const human::ArmLengths& lengths, const HumanOptions& human,
                  const std::vector<Vec3>& head, HumanMotion& motion);

}  // namespace morphe::reconstruct
