#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morphe::files {

/// Returns text that is safe for a terminal, a log or a line of a file: each control character (C0,
/// DEL, C1, line and paragraph separators, and bidirectional controls) is replaced by an escape
/// such as \u001b, each byte that is not UTF-8 by \xff. Characters in `allowed` are kept.
std::string make_printable(std::string_view text, std::string_view allowed = "");
/// Returns true if make_printable() would not change the text, as required for all names.
bool is_printable(std::string_view text);
/// Returns the number of bytes at the end that begin an incomplete character: 0 to 3.
std::size_t incomplete_utf8_bytes(std::string_view text);

}  // namespace morphe::files
