#pragma once

#include <filesystem>
#include <vector>

namespace morphe::commands {

/// Returns the given file, or the plans.h5 in the given folder of a run, or in its subfolders for a
/// run of several robots, sorted by path. Each is first read in a child process
/// (core/store/sandbox_probe.hpp). Throws InputError without a plans.h5, or if one cannot be read.
std::vector<std::filesystem::path> find_plans_files(const std::filesystem::path& named);

/// Returns the only file of find_plans_files(). Throws InputError with a list if there are several.
std::filesystem::path find_plans_file(const std::filesystem::path& named);

}  // namespace morphe::commands
