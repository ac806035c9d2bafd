#pragma once

#include <string_view>

namespace morphe::files {

/// A row of the table that CMake writes for files that are part of the program (cmake/embed.cmake).
struct EmbeddedFile {
  const char* name;
  const char* begin;
  const char* end;

  std::string_view text() const { return {begin, end}; }
};

}  // namespace morphe::files
