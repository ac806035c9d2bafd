#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Adds notes to `reports` on signs that the world moves or Z is not up: hands above the head, and
/// objects that move before a hand is near.
void check_world(const HandClip& clip, std::vector<std::string>& reports);

}  // namespace morphe::imports
