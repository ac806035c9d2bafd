#pragma once

#include "core/config/schema.hpp"

namespace morphe::scene {

/// What a file of objects (`scene.file`) may hold, if it is not a planning scene of MoveIt.
config::Schema scene_schema(const config::Meanings& meanings);

}  // namespace morphe::scene
