#pragma once

#include <filesystem>
#include <string>

#include "core/motion/input_error.hpp"

namespace morphe::imports {

/// A file of a folder from which no demonstration was imported.
struct SkippedFile {
  std::filesystem::path file;  ///< file or folder
  std::string reason;          ///< reason; lists contain only its first line
  bool failed = false;         ///< true for a recording that could not be read
};

/// Returns "FILE: why", or "FILE:LINE: why".
std::string skip_message(const SkippedFile& one);

/// Creates a skipped file from an error. If the message starts with the file at fault, the reason
/// does not repeat it.
SkippedFile skipped_file_from_error(const std::filesystem::path& file, const InputError& error);

}  // namespace morphe::imports
