#pragma once

#include "core/config/schema.hpp"

namespace morphe::robot {

/// Returns the schema of robot descriptions. load_robot() reports keys that it lacks before any
/// other error of the file. Combinations of keys and the existence of names are not part of it.
config::Schema robot_schema();

}  // namespace morphe::robot
