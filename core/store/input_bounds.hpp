#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::store {

/// Returns the reason why a demonstration cannot be processed in bounded time, "" if it can: times
/// that are not finite, do not increase, are denser than 100,000 per second or span more than 6
/// hours over all streams together; coordinates beyond 1000 km; rotations whose quaternion is far
/// from unit length; objects with a missing pose or a size that is not positive; body lengths that
/// are not positive. Example: "markers/time: row 3: must be greater than in the previous row".
/// Points and rotations of streams that are NaN were not observed and are valid.
std::string bounds_violation(const Demonstration& demonstration);

}  // namespace morphe::store
