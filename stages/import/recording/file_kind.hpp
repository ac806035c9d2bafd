#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace morphe::imports {

/// A kind of file that is no recording.
struct FileKind {
  std::string name;      ///< with its article: "a Git LFS pointer"
  std::string advice;    ///< a clause about the way to the recording: "fetch it: git lfs pull"
  bool pointer = false;  ///< true if it stands in the place of a file that was not fetched
};

/// Returns the kind of a file by its first bytes, if it is surely no recording, whatever its name.
std::optional<FileKind> foreign_file_kind(std::string_view head);

}  // namespace morphe::imports
