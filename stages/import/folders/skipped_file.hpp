#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/motion/input_error.hpp"
#include "stages/import/guess/unresolved_import.hpp"

namespace morphe::imports {

/// A file or folder from which no demonstration was imported.
struct SkippedFile {
  std::filesystem::path file;  ///< or folder
  std::string reason;          ///< may have several lines, of which lists show the first
  bool failed = false;         ///< true if it could not be read
  /// What the user must state before it can be read; null if that would not help.
  std::shared_ptr<const UnresolvedImport> question = {};
};

/// Returns "FILE: REASON", or "FILE:LINE: REASON", with the first line of the reason.
std::string skip_message(const SkippedFile& file);

/// Creates a file that failed, with the error's message, less a leading name of the file.
SkippedFile skipped_file_from_error(const std::filesystem::path& file, const InputError& error);

}  // namespace morphe::imports
