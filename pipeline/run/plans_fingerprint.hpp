#pragma once

#include <filesystem>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::run {

/// Returns the SHA-256 of the properties of a run in its plans.h5: config, inputs, dataset and
/// program. Two runs that plan the same have equal fingerprints.
std::string plans_fingerprint(const PlanFileHeader& header);
/// Returns the fingerprint of a file, "" if it cannot be read as plans.
std::string plans_fingerprint(const std::filesystem::path& plans);

}  // namespace morphe::run
