#pragma once

#include "core/config/schema.hpp"

namespace morphe::planning {

/// Returns the schema of a pipeline config, with `extends` and `robots`; `meanings` describe keys.
config::Schema config_schema(const config::KeyDescriptions& meanings);

}  // namespace morphe::planning
