#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// Writes the root attributes of plans.h5 and /inputs, in which folders are groups.
void write_plan_header(const Hdf5Group& root, const PlanFileHeader& header,
                       const std::string& robot_name);
/// Reads the header. Its inputs are in the order of creation within each folder.
PlanFileHeader read_plan_header(const Hdf5Group& root);

}  // namespace morphe::store
