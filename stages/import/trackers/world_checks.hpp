#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// What does not fit into a world that stands still, Z up, in `reports`: hands that are above the
/// head (another axis may be up), objects that move before a hand has come near (the frame itself
/// may be a camera's that moves). A hand without head and objects shows neither.
void check_world(const HandClip& clip, std::vector<std::string>& reports);

}  // namespace morphe::imports
