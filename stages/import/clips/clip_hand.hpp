#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

/// Returns the prefix of a side's keys, such as "mano_right_".
std::string clip_prefix(Side side);

/// Reads one side's hand, NaN in frames in which it was not seen; returns no value if the clip does
/// not have it. The joints are mano_<side>_joints in the order given by joint_order.hpp; _wrist_pos
/// is the wrist if the order has no wrist. The wrist's rotation is used if `rebuilt` is true,
/// otherwise only if the knuckles do not determine the orientation of the hand. Throws InputError
/// as ClipArrays does.
std::optional<RecordedHand> read_clip_hand(ClipArrays& clip, Side side, std::size_t rows,
                                           const TrackerFrame& frame, bool rebuilt,
                                           const Conventions& conventions,
                                           std::vector<std::string>& reports);

/// Returns wrist_from_hand: the orientation of the hand frame of HumanMotion (z to the fingers, y
/// to the thumb's side) in the frame of mano_<side>_wrist_rot (x to the fingers, z out of the back
/// of the hand).
Eigen::Matrix3d clip_wrist_from_hand(Side side);

}  // namespace morphe::imports
