#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// Which of a tool's joints is which keypoint, as KeypointOrder::joint, and how that is known.
struct JointOrder {
  std::array<int, kKeypoints> joint{};
  std::string because;  ///< a sentence for `reports`
};

/// By the names of the joints, whatever their order: "thumb_tip", "right_index_mcp",
/// "IndexFingerProximal", "pinky_distal". A segment stands at the root of its bone: proximal is
/// MCP, intermediate PIP, distal DIP (thumb: metacarpal or, without one, proximal is CMC).
/// Metacarpals of fingers, palm and forearm are no keypoints. `unknown` gets the names that say
/// nothing.
JointOrder order_by_names(const std::vector<std::string>& names, std::vector<std::string>& unknown);

/// Share of what is true of every hand that is true of this order of [N, J] joints, in the mean
/// over some frames: bones and palms of plausible proportions, knuckles side by side in their
/// order, no joint that folds back on itself, the thumb on the index's side.
double likeness_to_a_hand(const Table<Vec3>& joints, const std::array<int, kKeypoints>& order);

/// The order that is asked for (Conventions, else `in_file`, "" = not said), or that of those with
/// as many joints with which they are a hand. NotSaid "joint_order" if none is, or several are, as
/// they are while a recording is only looked at (not `judged`: the likeliest). InputError "FILE:
/// KEY: …" for an order of another count or a name that is none.
JointOrder joint_order_of(const Table<Vec3>& joints, const std::string& in_file,
                          const Conventions& conventions, const std::string& file,
                          const std::string& key);

}  // namespace morphe::imports
