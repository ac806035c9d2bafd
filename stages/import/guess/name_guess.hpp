#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/motion/side.hpp"

namespace morphe::imports {

/// Recorded names, each with one of Morphe's (arm_names.hpp).
using GuessedNames = std::vector<std::pair<std::string, std::string>>;

/// Guesses the names of a skeleton's joints from the words of their names and the hierarchy. A
/// finger is the chain of joints below the wrist whose names contain its word; if its joints are
/// side by side instead, their words decide. `parents` has the names of the joints' parents, which
/// precede them, or "". If no name has a side, all are those of `hand`. Joints without a guess are
/// left out.
GuessedNames guess_joints(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents, Side hand);

/// Guesses the names of points: markers (RUAR1, RLEP, …) if at least three are on one upper arm or
/// forearm, or if both sides of an elbow are present, otherwise joints. A name without a side is
/// that of `hand`, the recorded hand. Of several points on one landmark or joint the first is used.
/// 21 points numbered from 0, whose names have no part of an arm, are the keypoints of `hand`.
GuessedNames guess_points(const std::vector<std::string>& names, Side hand);

}  // namespace morphe::imports
