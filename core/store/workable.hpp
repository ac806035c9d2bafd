#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::store {

/// Why steps could not work on a demonstration in bounded time, "" if they can: times that are no
/// numbers, do not go forward, are more than 100,000 a second or span more than 6 hours over all
/// streams together; coordinates beyond 1000 km; rotations whose quaternion is far from unit
/// length; objects with a pose that is not there, or a size that is not positive; lengths of the
/// body that are not. "markers/time: row 3: does not follow the row before". Points and rotations
/// of streams that are NaN were not seen.
std::string why_unworkable(const Demonstration& demonstration);

}  // namespace morphe::store
