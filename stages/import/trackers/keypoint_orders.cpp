#include "stages/import/trackers/keypoint_orders.hpp"

#include <algorithm>

namespace morphe::imports {

const std::vector<KeypointOrder>& keypoint_orders() {
  // Each order lists wrist; thumb; index; middle; ring; little. A "segment" of a tool is at the
  // root of its bone: the proximal one is the MCP joint.
  static const std::vector<KeypointOrder> orders = {
      {"openpose",  // also MediaPipe, DexYCB and H2O
       21,
       {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20}},
      {"mano",  // its 16 joints, then the tips, thumb first
       21,
       {0, 13, 14, 15, 16, 1, 2, 3, 17, 4, 5, 6, 18, 10, 11, 12, 19, 7, 8, 9, 20}},
      {"flashdex",  // alphabetical by <finger>_<part>, without a wrist
       20,
       {-1, 18, 17, 16, 19, 2, 1, 0, 3, 6, 5, 4, 7, 14, 13, 12, 15, 10, 9, 8, 11}},
      {"aria",  // also HOT3D; the last is the palm
       21,
       {5, -1, 6, 7, 0, 8, 9, 10, 1, 11, 12, 13, 2, 14, 15, 16, 3, 17, 18, 19, 4}},
      {"openxr", 26, {1, 2, 3, 4, 5, 7, 8, 9, 10, 12, 13, 14, 15, 17, 18, 19, 20, 22, 23, 24, 25}},
      {"webxr",  // OpenXR's without the palm; Apple's hand skeleton
       25,
       {0, 1, 2, 3, 4, 6, 7, 8, 9, 11, 12, 13, 14, 16, 17, 18, 19, 21, 22, 23, 24}},
      {"arkit",  // the same followed by two joints of the forearm
       27,
       {0, 1, 2, 3, 4, 6, 7, 8, 9, 11, 12, 13, 14, 16, 17, 18, 19, 21, 22, 23, 24}},
      {"ovr", 24, {0, 3, 4, 5, 19, 6, 7, 8, 20, 9, 10, 11, 21, 12, 13, 14, 22, 16, 17, 18, 23}},
      {"manus",  // hand, thumb ×4, then metacarpal, proximal, intermediate, distal, tip per finger
       25,
       {0, 1, 2, 3, 4, 6, 7, 8, 9, 11, 12, 13, 14, 16, 17, 18, 19, 21, 22, 23, 24}},
  };
  return orders;
}

const KeypointOrder* keypoint_order(std::string_view name) {
  const auto& orders = keypoint_orders();
  const auto found = std::ranges::find(orders, name, &KeypointOrder::name);
  return found == orders.end() ? nullptr : &*found;
}

}  // namespace morphe::imports
