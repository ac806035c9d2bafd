#pragma once

#include <filesystem>

namespace morphe::files {

/// Finds the file that a user names: `named` itself if it exists or is absolute, else the same path
/// below Morphe's shipped files. These are in share/morphe next to the bin or lib folder of the
/// running program or library, or in the sources above its build folder. If the file is in neither,
/// returns the path whose folder exists, for an error message; `named` if both or neither do.
std::filesystem::path resolve_data_file(const std::filesystem::path& named);

/// Does the same for the folder `shipped`, "" if there is no such folder.
std::filesystem::path resolve_data_file(const std::filesystem::path& named,
                                        const std::filesystem::path& shipped);

}  // namespace morphe::files
