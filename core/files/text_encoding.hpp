#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace morphe::files {

/// Returns true if the text is valid UTF-8.
bool is_utf8(std::string_view text);
/// Appends a code point, at most 0x10FFFF, in UTF-8.
void append_utf8(std::uint32_t point, std::string& text);
/// Converts text from ISO 8859-1, the usual one-byte encoding of western Europe, to UTF-8.
std::string utf8_from_latin1(std::string_view text);

}  // namespace morphe::files
