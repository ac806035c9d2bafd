#pragma once

#include "core/motion/plan_request.hpp"

namespace morphe::planning {

/// Returns the request that a plans.h5 was made for, from its header alone: the effective config is
/// parsed like a config, and robot and scene are rebuilt from the stored inputs. Throws InputError
/// if one of them cannot be read, or is not in the form that this version writes. A header contains
/// no meshes: for a mesh object only the name is known (`relative_to` is unknown), and for a scene
/// file with meshes no objects are known.
PlanRequest plan_requirements(const PlanFileHeader& header);

}  // namespace morphe::planning
