#pragma once

#include "core/config/schema.hpp"

namespace morphe::robot {

/// What a robot description may hold. The reader tells a key that is not in it before anything else
/// of the file; which keys belong together and what names must exist, it alone knows.
config::Schema robot_schema();

}  // namespace morphe::robot
