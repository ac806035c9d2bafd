#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// Joins the folders of all shards of a run into `plans`: the bytes that one run over the whole
/// dataset would have written. InputError "merge: …", one line that lists all that is wrong: shards
/// that are missing, there twice, not finished, or of another config, robot, dataset or build; and
/// what Journal says of a folder. Returns the counts over all shards.
BatchSummary merge_shards(const std::vector<std::filesystem::path>& folders,
                          const std::filesystem::path& plans);

}  // namespace morphe::run
