#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// What a clip of tracked hands says about itself, in the world and in metres: of each hand what
/// there is, its own joints and those called so among the body's. In `reports`: frames
/// in which a hand was not seen, bones that change their length (a wrong convention does that) and
/// rows that come too slowly for a reach. NotSaid "unit" if a hand's size is no person's (not of
/// one that is among the body's joints alone, a skeleton's, and not if it is not `judged`).
/// InputError if the fingers of a hand curl as those of the other side do: exchanged sides and
/// mirrored axes look like this.
void check_hands(const std::string& file, const HandClip& clip, bool judged,
                 std::vector<std::string>& reports);

}  // namespace morphe::imports
