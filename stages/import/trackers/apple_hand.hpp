#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// A joint's name as programs write it, in small letters and without "finger":
/// "indexFingerKnuckle", "IndexKnuckle" and "index_knuckle" are "indexknuckle".
std::string plain_apple_name(std::string_view name);

/// Plain names in the order of keypoints: "wrist", "thumbknuckle", … "littletip". A finger's
/// knuckle is its MCP joint, the thumb's its CMC; metacarpals are no keypoints.
const std::array<std::string, kKeypoints>& apple_joints();

/// A rigid motion from the 16 numbers of a matrix, none if it is none: its rotation must be one
/// within 1 %, its fourth row 0, 0, 0, 1.
std::optional<Pose> rigid_motion(const std::vector<double>& numbers, bool column_major);

/// Why a clip from Apple's hand tracking has the axes that it has, for `reports`.
inline constexpr const char* kAppleAxes =
    "Y is up by the device's gravity, as in ARKit; which way the person faces is not said";

}  // namespace morphe::imports
