#pragma once

#include <string>

#include "pipeline/motion/demonstration.hpp"

namespace morphe {

/// InputError "FILE: unit: …" if a point is more than 1 km from the origin or an angle beyond three
/// turns: no recording of a person, whatever its file says.
void check_plausible(const std::string& file, const Demonstration& demonstration);

}  // namespace morphe
