#pragma once

#include <filesystem>

namespace morphe::files {

/// Finds the file that a user names: the path as named if it exists; otherwise the file of that
/// name among those shipped with Morphe: the installed ones, below share/morphe next to the bin or
/// lib folder of the running program or library, or the sources above its build folder. If neither
/// exists, it returns the path whose folder exists, for use in an error message; the path as named
/// if both or neither folder exists.
std::filesystem::path resolve_data_file(const std::filesystem::path& named);

/// Does the same for a given folder of installed files, "" if there is no such folder.
std::filesystem::path resolve_data_file(const std::filesystem::path& named,
                                        const std::filesystem::path& shipped);

}  // namespace morphe::files
