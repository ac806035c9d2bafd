#pragma once

#include "core/motion/asked.hpp"

namespace morphe::planning {

/// What a plans.h5 was asked to be, from its header alone: the effective config is read as a config
/// is, robot and scene are made anew from the stored inputs. InputError: one of them cannot be
/// read, or is not as this version writes it. A header holds no meshes: of an object that is one
/// only the name is known (`relative_to` is unknown), and of a scene file with meshes nothing.
Asked asked_of(const PlanFileHeader& header);

}  // namespace morphe::planning
