#pragma once

#include <filesystem>

namespace morphe::files {

/// The file that a user names: as it is named if it is there; otherwise the one of that name among
/// those that come with Morphe: the installed ones, below share/morphe beside the bin or lib folder
/// of what runs this, or the sources above its build folder. In neither place: the one whose folder
/// is there, for an error to name; as it is named where both or none are.
std::filesystem::path here_or_shipped(const std::filesystem::path& named);

/// The same with the folder that holds the installed files, "" if there is none.
std::filesystem::path here_or_shipped(const std::filesystem::path& named,
                                      const std::filesystem::path& shipped);

}  // namespace morphe::files
