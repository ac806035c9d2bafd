#pragma once

#include <filesystem>
#include <vector>

namespace morphe::commands {

/// A file as it is named, or the plans.h5 of a run's folder: of a run with several robots one each,
/// by name. InputError: a folder without any.
std::vector<std::filesystem::path> plans_files(const std::filesystem::path& named);

/// The one of them. InputError: the run's folder holds several, which the error lists.
std::filesystem::path plans_file(const std::filesystem::path& named);

}  // namespace morphe::commands
