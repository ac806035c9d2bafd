#pragma once

#include <filesystem>
#include <vector>

#include "stages/import/folders/skipped_file.hpp"

namespace morphe::imports {

/// The contents of a folder, including its subfolders.
struct FolderFiles {
  std::vector<std::filesystem::path> files;  ///< in natural order
  std::vector<SkippedFile> left_out;         ///< skipped entries, with reasons
};

/// Lists the files of a folder. Links are followed, and each folder is entered once, regardless of
/// the number of links to it. Skipped are hidden files, folders of earlier runs, `results`, entries
/// that are not files, and entries that cannot be read or have a name that is invalid in a
/// manifest. Throws InputError if the folder itself cannot be read.
FolderFiles list_files(const std::filesystem::path& folder, const std::filesystem::path& results);

/// Returns the names of the folders on a path, except for "." and "..".
std::vector<std::string> folder_names(const std::filesystem::path& path);

}  // namespace morphe::imports
