#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// The order of a recording's joints.
struct JointOrder {
  std::array<int, kKeypointCount> joint{};  ///< as KeypointOrder::joint
  std::string because;                      ///< how it was found: a sentence for import_notes
};

/// Determines the order from the names of the joints: "thumb_tip", "right_index_mcp",
/// "IndexFingerProximal", "pinky_distal". A name of a bone denotes the joint at its root: proximal
/// is MCP, intermediate PIP, distal DIP. For the thumb, metacarpal is CMC; if no name is, proximal.
/// Metacarpals of fingers, palm and forearm are ignored. `unknown` gets all other names, repeated
/// ones included.
JointOrder order_by_names(const std::vector<std::string>& names, std::vector<std::string>& unknown);

/// Returns the ratio of satisfied conditions for a human hand, over up to 100 frames of [N, J]
/// joints in this order: bones and palm have plausible proportions, knuckles are side by side in
/// sequence, no joint is folded back on itself, and the thumb is on the index finger's side.
double hand_similarity(const Array2D<Vec3>& joints, const std::array<int, kKeypointCount>& order);

/// Throws UnresolvedConvention "joint_order" if the joints are no hand in the order that the file
/// states, by name or by the names of the joints.
void expect_hand_in_order(const Array2D<Vec3>& joints, const JointOrder& stated,
                          const std::string& file, const std::string& key);

/// Returns the order that `conventions` or, without, `in_file` names; if both are "", the only
/// known order of as many joints in which the joints form a hand. Throws UnresolvedConvention
/// "joint_order" if they contradict that of the file, or form a hand in no known order or in
/// several (without plausibility checks, only if no order has as many joints; otherwise the
/// likeliest is returned). Throws InputError "FILE: KEY: …" for a named order that is unknown or
/// has another number of joints.
JointOrder joint_order_of(const Array2D<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key);

}  // namespace morphe::imports
