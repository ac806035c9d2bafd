#pragma once

#include "core/config/schema.hpp"

namespace morphe::planning {

/// What a pipeline config may hold: sections, `extends` and `robots`.
config::Schema config_schema(const config::Meanings& meanings);

}  // namespace morphe::planning
