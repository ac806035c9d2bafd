#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// Writes the plans of all shards of a run into the file `plans`, with the bytes that one run over
/// the whole dataset would have written. Returns the counts over all shards. Throws InputError with
/// all shards that are missing, duplicated, unfinished, or of another config, robot, dataset or
/// build; also for faults that Journal reports, and if `plans` belongs to another run.
BatchSummary merge_shards(const std::vector<std::filesystem::path>& folders,
                          const std::filesystem::path& plans);

}  // namespace morphe::run
