#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// The root attributes of plans.h5 and /inputs, where a file's folders are groups. Reading gives
/// the inputs folder by folder, each in the order of its creation.
void write_plan_header(const Hdf5Group& root, const PlanFileHeader& header,
                       const std::string& robot_name);
PlanFileHeader read_plan_header(const Hdf5Group& root);

}  // namespace morphe::store
