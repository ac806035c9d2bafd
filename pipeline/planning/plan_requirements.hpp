#pragma once

#include "core/motion/plan_request.hpp"

namespace morphe::planning {

/// Returns the requirements that a plans.h5 was made for, from its header alone: the stored config
/// is parsed, and robot and scene are rebuilt from the stored inputs. A header contains no meshes.
/// Therefore only the name of a mesh object of the config is known (`relative_to` is unknown), and
/// no object of a scene file with meshes. Throws InputError if config or robot cannot be read, the
/// scene file is missing, or the config is not in the form that this version writes.
PlanRequest plan_requirements(const PlanFileHeader& header);

}  // namespace morphe::planning
