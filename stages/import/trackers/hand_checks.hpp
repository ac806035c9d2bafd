#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Checks the hands of a clip in the world and in metres. All joints of a hand are used, its own
/// and those among the body's. Adds to `reports` the frames in which a hand was not seen, bones of
/// variable length (as caused by a wrong convention) and a frame rate too low for a reach. Throws
/// UnresolvedConvention "unit" if a hand's size is not a person's (except for a hand that is only
/// among the body's joints, as in a skeleton, and if it is not `judged`). Throws InputError if the
/// fingers of a hand curl as those of the other side do, as caused by exchanged sides and mirrored
/// axes.
void check_hands(const std::string& file, const HandClip& clip, bool judged,
                 std::vector<std::string>& reports);

}  // namespace morphe::imports
