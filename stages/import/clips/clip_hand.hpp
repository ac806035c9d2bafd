#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

/// "mano_right_": what the keys of a side begin with.
std::string clip_prefix(Side side);

/// One side's hand, NaN where it was not seen; nothing if the clip has none: mano_<side>_joints in
/// the order that is told (joint_order.hpp) and _wrist_pos, which is the wrist where the order has
/// none. `rebuilt`: the wrist's rotation is taken, too; otherwise only where no knuckles show how
/// the hand is turned. InputError as ClipArrays says.
std::optional<RecordedHand> read_clip_hand(ClipArrays& clip, Side side, std::size_t rows,
                                           const TrackerFrame& frame, bool rebuilt,
                                           const Conventions& conventions,
                                           std::vector<std::string>& reports);

/// The rotation of mano_<side>_wrist_rot (x to the fingers, z out of the back of the hand) from the
/// hand frame of HumanMotion (z to the fingers, y to the thumb's side), and the other way round.
Eigen::Matrix3d clip_wrist_from_hand(Side side);

}  // namespace morphe::imports
