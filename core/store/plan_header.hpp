#pragma once

#include <string>

#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"
#include "core/store/hdf5_file.hpp"
#include "core/store/layout_contract.hpp"

namespace morphe::store {

/// Returns the SHA-256 of all from which plans were made, which is that of these lines (sha256sum
/// prints such), each HASH two spaces NAME and a line feed:
///   settings        of the settings, each followed by a line feed
///   inputs/PATH     of the bytes of each input, sorted by the bytes of PATH
///   dataset         dataset_sha256 itself
MORPHE_EXPORT std::string inputs_hash(const PlanFileHeader& header);

/// Writes the root attributes of plans.h5 and /inputs, in which folders are groups. Inputs that are
/// text (UTF-8 without NUL) become texts, others arrays of bytes. Throws InputError for a setting
/// of several lines.
void write_plan_header(Hdf5Group root, PlanFileHeader header, const std::string& robot_name);
/// Reads the header. Its inputs are in the order of creation within each folder.
PlanFileHeader read_plan_header(Hdf5Group root);
/// Compares the root attributes, the inputs and the assumptions with what write_plan_header() would
/// write for a header that was read.
void compare_plan_header(LayoutContract& root, const PlanFileHeader& header,
                         const std::string& robot_name);

}  // namespace morphe::store
