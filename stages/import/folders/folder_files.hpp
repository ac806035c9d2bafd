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

/// Lists the files of a folder. Links are followed within the folder, but no folder is entered
/// twice. Skipped are links out of the folder, hidden entries, folders of earlier runs, the folder
/// `results` (empty: no such folder), folders that cannot be opened, and entries that are not
/// regular files or have control characters or invalid UTF-8 in their names. Throws InputError if
/// the folder itself cannot be opened.
FolderFiles list_files(const std::filesystem::path& folder, const std::filesystem::path& results);

/// Returns the components of a path, except for "/", "." and "..".
std::vector<std::string> folder_names(const std::filesystem::path& path);

}  // namespace morphe::imports
