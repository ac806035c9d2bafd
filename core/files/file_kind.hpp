#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/files/given_files.hpp"

namespace morphe::files {

/// A kind of file that is known by its first bytes, whatever its name.
struct FileKind {
  std::string name;      ///< with its article: "a Git LFS pointer"
  std::string advice;    ///< a clause about the way to the content: "unpack it"; may be ""
  bool pointer = false;  ///< true if it stands in the place of a file that was not fetched
  /// True if the advice leads to the file that was meant, whatever its content; otherwise it is for
  /// recordings.
  bool unwrapped = false;
};

/// Returns the kind by the first bytes, no value for other kinds.
std::optional<FileKind> file_kind(std::string_view head);

/// Returns the name of the root element of an XML text, in lower case, without comments before it;
/// "" for other texts.
std::string xml_root_name(std::string_view text);

/// Returns the first 64 KB of a file as UTF-8 without byte order mark, if it is text. Throws
/// InputError if it cannot be read, or is a pipe.
std::string read_file_head(const std::filesystem::path& file, const GivenFiles* given = nullptr);

}  // namespace morphe::files
