#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/motion/side.hpp"

namespace morphe::imports {

/// Recorded name -> one of Morphe's (arm_names.hpp).
using GuessedNames = std::vector<std::pair<std::string, std::string>>;

/// What the joints of a skeleton are, by the words in their names and by who follows whom: a finger
/// is the chain of joints below the wrist whose names have its word, whatever its numbers.
/// `parents` holds names. Joints that come to nothing are left out.
GuessedNames guess_joints(const std::vector<std::string>& names,
                          const std::vector<std::string>& parents);

/// What points are. Where three or more of upper arm or forearm bear its name, or both sides of the
/// elbow are there, they are markers (RUAR1, RLEP, …), otherwise joints. Names without a side are
/// the recorded hand's. Two points that would be one thing: the first, in the order of the file. 21
/// points without words, numbered from 0: a hand's, in the order of keypoints.
GuessedNames guess_points(const std::vector<std::string>& names, Side hand);

}  // namespace morphe::imports
