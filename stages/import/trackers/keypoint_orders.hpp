#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::imports {

inline constexpr std::size_t kKeypoints = 1 + 4 * kFingers;

/// The order in which a tool lists a hand's joints. Keypoints are the wrist, then four a finger
/// from its base to its tip, thumb first (CMC, MCP, IP, tip; the others MCP, PIP, DIP, tip).
struct KeypointOrder {
  std::string_view name;                ///< "openpose", "aria", "openxr", …
  std::size_t joints = 0;               ///< in the tool's list
  std::array<int, kKeypoints> joint{};  ///< keypoint k is the list's joint [k]; -1 = it has none
};

/// Every order there is.
const std::vector<KeypointOrder>& keypoint_orders();

/// The order of that name, null if there is none.
const KeypointOrder* keypoint_order(std::string_view name);

}  // namespace morphe::imports
