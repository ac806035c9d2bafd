#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morphe::files {

/// Text that a terminal, a log or a line of a file may be shown: each control character (C0, DEL,
/// C1, line and paragraph separators, and those that turn the direction of writing) stands as
/// \u001b, each byte that is no UTF-8 as \xff. The characters of `allowed` stay.
std::string printable(std::string_view text, std::string_view allowed = "");
/// Whether printable() would change it: no name of a thing does.
bool is_printable(std::string_view text);
/// Bytes at the end that begin a letter whose other bytes are still to come: 0 to 3.
std::size_t unfinished_letter(std::string_view text);

}  // namespace morphe::files
