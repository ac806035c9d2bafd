#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// Returns the canonical form of a joint's name, in small letters and without "finger":
/// "indexFingerKnuckle", "IndexKnuckle" and "index_knuckle" are "indexknuckle".
std::string normalized_apple_name(std::string_view name);

/// Returns the canonical names in the order of keypoints: "wrist", "thumbknuckle", … "littletip". A
/// finger's knuckle is its MCP joint, the thumb's its CMC; metacarpals are not keypoints.
const std::array<std::string, kKeypointCount>& apple_joints();

/// Returns the rigid motion given by the 16 numbers of a matrix, or no value if it is not rigid:
/// its rotation must be orthonormal within 1 %, its fourth row 0, 0, 0, 1.
std::optional<Pose> pose_from_matrix(const std::vector<double>& numbers, bool column_major);

/// The reason for the axes of a clip from Apple's hand tracking, for `reports`.
inline constexpr const char* kAppleAxesReason =
    "Y is up (gravity, as in ARKit); facing direction not in the file";

}  // namespace morphe::imports
