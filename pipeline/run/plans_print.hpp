#pragma once

#include <filesystem>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::run {

/// SHA-256 of what a plans.h5 says of its run: config, inputs, dataset, program. Two runs that plan
/// the same have the same.
std::string plans_print(const PlanFileHeader& header);
/// Of a file; "" if it cannot be read as plans.
std::string plans_print(const std::filesystem::path& plans);

}  // namespace morphe::run
