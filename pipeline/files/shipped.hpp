#pragma once

#include <filesystem>

namespace morphe::files {

/// The file that a user names: as it is named if it is there; otherwise the one of that name among
/// the installed ones, below share/morphe beside the bin or lib folder of what runs this; as it is
/// named if Morphe was not installed. InputError if it is in neither place.
std::filesystem::path here_or_shipped(const std::filesystem::path& named);

/// The same with the folder that holds the installed files, "" if there is none.
std::filesystem::path here_or_shipped(const std::filesystem::path& named,
                                      const std::filesystem::path& shipped);

}  // namespace morphe::files
