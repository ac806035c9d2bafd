#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// Joins the folders of all shards of a run into `plans`, with the bytes that one run over the
/// whole dataset would have written. Returns the counts over all shards. Throws InputError "merge:
/// …", one line that lists all faults: shards that are missing, duplicated, unfinished, or of
/// another config, robot, dataset or build; and the faults that Journal reports for a folder.
BatchSummary merge_shards(const std::vector<std::filesystem::path>& folders,
                          const std::filesystem::path& plans);

}  // namespace morphe::run
