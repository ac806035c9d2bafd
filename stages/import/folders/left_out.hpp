#pragma once

#include <filesystem>
#include <string>

#include "core/motion/input_error.hpp"

namespace morphe::imports {

/// What a folder holds and no demonstration came of.
struct LeftOut {
  std::filesystem::path file;  ///< or folder
  std::string why;             ///< its first line is told in lists
  bool failed = false;         ///< a recording that could not be read
};

/// "FILE: why", or "FILE:LINE: why".
std::string sentence_of(const LeftOut& one);

/// The file at fault stands in front of an error's message, and not a second time in `why`.
LeftOut unreadable(const std::filesystem::path& file, const InputError& error);

}  // namespace morphe::imports
