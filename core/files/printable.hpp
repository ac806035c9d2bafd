#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morphe::files {

/// Returns text that is safe for a terminal, a log or a line of a file: control characters (C0,
/// DEL, C1, line and paragraph separators, bidirectional controls) are replaced by escapes like
/// \u001b, bytes that are not UTF-8 by \xff. One-byte characters in `allowed` are kept.
std::string make_printable(std::string_view text, std::string_view allowed = "");
/// Returns true if make_printable() would not change the text, as required for all names.
bool is_printable(std::string_view text);
/// Returns the number of bytes at the end that begin an incomplete character: 0 to 3.
std::size_t incomplete_utf8_bytes(std::string_view text);

}  // namespace morphe::files
