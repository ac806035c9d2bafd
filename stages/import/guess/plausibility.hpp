#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Throws InputError "FILE: unit: …" if a point is more than 1 km from the origin or an angle
/// exceeds three turns, and "FILE: time: …" if the recording, over all its streams, takes more than
/// 6 hours, or a step 10 minutes: these exceed any recording of a person's arm.
void check_plausibility(const std::string& file, const Demonstration& demonstration);

}  // namespace morphe::imports
