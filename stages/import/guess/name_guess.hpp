#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/motion/side.hpp"

namespace morphe::imports {

/// Recorded names, each with one of Morphe's (arm_names.hpp).
using GuessedNames = std::vector<std::pair<std::string, std::string>>;

/// Guesses the names of a skeleton's joints from the words in their names and from the hierarchy: a
/// finger is the chain of joints below the wrist whose names contain its word, regardless of the
/// numbers. `parents` contains names. Joints without a guess are left out.
GuessedNames guess_joints(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents);

/// Guesses the names of points. If three or more have the name of an upper arm or forearm, or both
/// sides of the elbow are present, they are markers (RUAR1, RLEP, …), otherwise joints. Names
/// without a side are the recorded hand's. If two points would have the same name, the first in the
/// order of the file is used. 21 points without words, numbered from 0, are a hand's in the order
/// of keypoints.
GuessedNames guess_points(const std::vector<std::string>& names, Side hand);

}  // namespace morphe::imports
