#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/import/clips/clip_arrays.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

/// Returns the prefix of a side's keys, such as "mano_right_".
std::string clip_prefix(Side side);

/// Reads the hand of a side, in the world; no value if the clip does not have it. Its joints are
/// mano_<side>_joints, in the order that joint_order.hpp determines. In frames without a wrist
/// among them, mano_<side>_wrist_pos is the wrist. The rotation mano_<side>_wrist_rot is used only
/// for a `reconstructed` motion, or if no frame has the wrist, index and little knuckles. `rows` is
/// the number of frames of the clip.
std::optional<RecordedHand> read_clip_hand(ClipArrays& clip, Side side, std::size_t rows,
                                           const TrackerFrame& frame, bool reconstructed,
                                           const Conventions& conventions,
                                           std::vector<std::string>& reports);

/// Returns wrist_from_hand, from the hand frame of HumanMotion (z to the fingers, y to the thumb's
/// side) to the frame of mano_<side>_wrist_rot (x to the fingers, z out of the back of the hand).
Eigen::Matrix3d clip_wrist_from_hand(Side side);

}  // namespace morphe::imports
