#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Checks the hands of a clip; joints of a hand may also be among those of `clip.body`. Adds notes
/// to `reports` on unseen frames, bones of variable length (an effect of wrong conventions) and a
/// frame rate too low for a reach. If `is_checked`, throws UnresolvedConvention "unit" if the palm
/// of one of `clip.hands` is not as long as a person's, InputError if fingers curl like those of
/// the other side (an effect of exchanged sides or mirrored axes).
void check_hands(const std::string& file, const HandClip& clip, bool is_checked,
                 std::vector<std::string>& reports);

}  // namespace morphe::imports
