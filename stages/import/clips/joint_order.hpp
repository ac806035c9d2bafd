#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// The mapping from a tool's joints to keypoints, as KeypointOrder::joint, and its reason.
struct JointOrder {
  std::array<int, kKeypointCount> joint{};  ///< keypoint k is joint [k]; -1 if absent
  std::string because;                      ///< a sentence for `reports`
};

/// Determines the order from the names of the joints, in any sequence: "thumb_tip",
/// "right_index_mcp", "IndexFingerProximal", "pinky_distal". A segment's joint is at the root of
/// its bone: proximal is MCP, intermediate PIP, distal DIP (thumb: metacarpal or, without one,
/// proximal is CMC). Metacarpals of fingers, palm and forearm are not keypoints. `unknown` gets the
/// names that cannot be interpreted.
JointOrder order_by_names(const std::vector<std::string>& names, std::vector<std::string>& unknown);

/// Returns the share of the conditions for a human hand that [N, J] joints satisfy in this order,
/// averaged over some frames: bones and palms of plausible proportions, knuckles side by side in
/// sequence, no joint folded back on itself, the thumb on the index's side.
double hand_similarity(const Array2D<Vec3>& joints, const std::array<int, kKeypointCount>& order);

/// Returns the requested order (Conventions, otherwise `in_file`, "" if absent), or that of the
/// orders with the same number of joints with which they form a hand. Throws UnresolvedConvention
/// "joint_order" if no order does, or if several do, which is always the case while a recording is
/// only inspected (not `judged`: the likeliest). Throws InputError "FILE: KEY: …" for an order with
/// a different number of joints or an unknown name.
JointOrder joint_order_of(const Array2D<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key);

}  // namespace morphe::imports
