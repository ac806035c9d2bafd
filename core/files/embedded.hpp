#pragma once

#include <string_view>

namespace morphe::files {

/// An entry of the table that CMake generates for files embedded in the program
/// (cmake/embed.cmake).
struct EmbeddedFile {
  const char* name;
  const char* begin;
  const char* end;

  /// Returns the content of the file.
  std::string_view text() const { return {begin, end}; }
};

}  // namespace morphe::files
