#pragma once

#include <filesystem>
#include <string>

#include "core/motion/plan.hpp"

namespace morphe::run {

/// Returns the SHA-256 of the header of a plans.h5: config, inputs, dataset and program, whatever
/// the order of the inputs. Runs with equal fingerprints write equal plans.
std::string plans_fingerprint(const PlanFileHeader& header);
/// Returns the fingerprint of a file, "" if it cannot be read as plans.
std::string plans_fingerprint(const std::filesystem::path& plans);

}  // namespace morphe::run
