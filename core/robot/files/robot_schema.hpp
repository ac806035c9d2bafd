#pragma once

#include "core/config/schema.hpp"

namespace morphe::robot {

/// Returns the schema of robot descriptions. Unknown keys are reported before any other error of
/// the file. The reader alone checks the combinations of keys and the existence of names.
config::Schema robot_schema();

}  // namespace morphe::robot
