#pragma once

#include <filesystem>
#include <vector>

namespace morphe::commands {

/// A file as it is named, or the plans.h5 of a run's folder: of a run with several robots one each,
/// by name. Each is read in a child process first (store/harmless.hpp). InputError: a folder
/// without any, or a file that is not to be read.
std::vector<std::filesystem::path> plans_files(const std::filesystem::path& named);

/// The one of them. InputError: the run's folder holds several, which the error lists.
std::filesystem::path plans_file(const std::filesystem::path& named);

}  // namespace morphe::commands
