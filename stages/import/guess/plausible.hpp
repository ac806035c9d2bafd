#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// InputError "FILE: unit: …" if a point is more than 1 km from the origin or an angle beyond three
/// turns, "FILE: time: …" if the recording, over all its streams, takes more than 6 hours, or a
/// step 10 minutes: no recording of a person's arm, whatever its file says.
void check_plausible(const std::string& file, const Demonstration& demonstration);

}  // namespace morphe::imports
