#pragma once

#include <filesystem>
#include <vector>

namespace morphe::commands {

/// Returns the given file, or the plans.h5 of a run's folder; for a run with several robots, one
/// for each, sorted by name. Each is first read in a child process (core/store/sandbox_probe.hpp).
/// Throws InputError for a folder without plans.h5, or for a file that cannot be read.
std::vector<std::filesystem::path> find_plans_files(const std::filesystem::path& named);

/// Returns the only such file. Throws InputError with a list of the files if the run's folder
/// contains several.
std::filesystem::path find_plans_file(const std::filesystem::path& named);

}  // namespace morphe::commands
