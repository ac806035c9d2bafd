#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Throws for values beyond any recording of a person's arm: UnresolvedConvention "unit" for a
/// coordinate above 1 km, InputError "FILE: unit: …" for an angle above three turns, and "FILE:
/// time: …" for a step above 10 minutes, or above 6 hours from the first to the last time.
void check_plausibility(const std::string& file, const Demonstration& demonstration);

}  // namespace morphe::imports
