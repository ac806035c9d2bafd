#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Removes from all streams and objects the rows whose time is that of the row before, and adds a
/// note about them. Throws UnresolvedConvention "rate", prefixed by `source`, if these are more
/// than a twentieth of the rows: the clock is then too coarse to tell the rows apart.
void drop_repeated_rows(const std::string& source, Demonstration& demonstration);

}  // namespace morphe::imports
