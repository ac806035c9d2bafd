#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// Returns the canonical form of a joint's name, in small letters without '_' and "finger":
/// "indexFingerKnuckle", "IndexKnuckle" and "index_knuckle" become "indexknuckle".
std::string normalized_apple_name(std::string_view name);

/// Returns the canonical names of the keypoints in their order: "wrist", "thumbknuckle", …
/// "littletip". A finger's knuckle is its MCP joint, the thumb's knuckle its CMC joint.
const std::array<std::string, kKeypointCount>& apple_joints();

/// Returns the pose in a 4 x 4 matrix of 16 numbers, in metres. Returns no value unless its
/// rotation is orthonormal within 1 % and its fourth row is 0, 0, 0, 1.
std::optional<Pose> pose_from_matrix(const std::vector<double>& numbers, bool column_major);

/// `axes_reason` of tracker_frame() for Apple's hand tracking.
inline constexpr const char* kAppleAxesReason =
    "Y is up (gravity, as in ARKit); facing direction not in the file";

}  // namespace morphe::imports
