#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Adds to `reports` observations that contradict a stationary world with Z up: hands above the
/// head (another axis may be up), and objects that move before a hand is near (the frame may be
/// that of a moving camera). A hand without head and objects allows neither check.
void check_world(const HandClip& clip, std::vector<std::string>& reports);

}  // namespace morphe::imports
