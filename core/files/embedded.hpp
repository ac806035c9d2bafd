#pragma once

#include <string_view>

namespace morphe::files {

/// An entry of the generated table of files embedded in the program (cmake/embed.cmake).
struct EmbeddedFile {
  const char *name, *begin, *end;

  /// Returns the content of the file.
  std::string_view text() const { return {begin, end}; }
};

}  // namespace morphe::files
