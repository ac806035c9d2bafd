#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::imports {

inline constexpr int kKeypointCount = 1 + 4 * kFingerCount;  ///< the wrist and four per finger

/// The order in which a tool lists a hand's joints. Keypoints are the wrist, then four per finger
/// from its base to its tip, thumb first (CMC, MCP, IP, tip; the others MCP, PIP, DIP, tip).
struct KeypointOrder {
  std::string_view name;                    ///< "openpose", "aria", "openxr", …
  std::size_t joints = 0;                   ///< number of joints in the tool's list
  std::array<int, kKeypointCount> joint{};  ///< [k] index of keypoint k in the list; -1 if absent
};

/// Returns all orders.
const std::vector<KeypointOrder>& keypoint_orders();

/// Returns the order of that name, null if there is no such order.
const KeypointOrder* keypoint_order(std::string_view name);

}  // namespace morphe::imports
