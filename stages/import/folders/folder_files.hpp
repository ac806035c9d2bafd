#pragma once

#include <filesystem>
#include <vector>

#include "stages/import/folders/left_out.hpp"

namespace morphe::imports {

/// What a folder holds, in folders of folders too.
struct FolderFiles {
  std::vector<std::filesystem::path> files;  ///< in natural order
  std::vector<LeftOut> left_out;
};

/// Links are followed, each folder is entered once, however many lead to it. Left out are hidden
/// files, folders of earlier runs, `results`, what is no file, and what cannot be read or has a
/// name that no manifest can hold. InputError if the folder itself cannot be read.
FolderFiles files_below(const std::filesystem::path& folder, const std::filesystem::path& results);

/// The names of the folders on a path, but for "." and "..".
std::vector<std::string> folders_on(const std::filesystem::path& path);

}  // namespace morphe::imports
