#pragma once

#include "core/motion/plan_request.hpp"

namespace morphe::planning {

/// Returns the requirements that a plans.h5 was made for, from its header alone: config, robot,
/// scene and meshes are read again from the stored inputs and settings (reload_config()), and what
/// the header itself says is compared with them. Throws InputError if these cannot be read.
PlanRequest plan_requirements(const PlanFileHeader& header);

}  // namespace morphe::planning
