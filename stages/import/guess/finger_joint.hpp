#pragma once

#include <string>

#include "stages/import/guess/recorded_name.hpp"

namespace morphe::imports {

/// Returns the joint of finger `finger_index` (of kFingerNames) that the words of a name, or its
/// last number, denote, such as "index_pip"; the tip without both, and "" for a joint in the palm.
std::string finger_joint_of(const RecordedName& name, std::size_t finger_index);

}  // namespace morphe::imports
