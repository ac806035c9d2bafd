#pragma once

#include <string>
#include <vector>

#include "stages/import/hand_clip.hpp"

namespace morphe::imports {

/// What a clip of tracked hands says about itself, in the world and in metres. In `reports`: frames
/// in which a hand was not seen, bones that change their length (a wrong convention does that) and
/// rows that come too slowly for a reach. NotSaid "unit" if a hand's size is no person's (not if it
/// is not `judged`). InputError if the fingers of a hand curl as those of the other side do:
/// exchanged sides and mirrored axes look like this.
void check_hands(const std::string& file, const HandClip& clip, bool judged,
                 std::vector<std::string>& reports);

}  // namespace morphe::imports
