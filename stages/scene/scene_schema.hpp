#pragma once

#include "core/config/schema.hpp"

namespace morphe::scene {

/// Returns the schema of a file of objects (`scene.file`) that is not a MoveIt planning scene.
config::Schema scene_schema(const config::KeyDescriptions& meanings);

}  // namespace morphe::scene
