#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace morphe::files {

/// Returns true if the text is valid UTF-8.
bool is_utf8(std::string_view text);
/// Appends a code point, at most 0x10FFFF, in UTF-8.
void append_utf8(std::uint32_t point, std::string& text);
/// Converts text from ISO 8859-1, the usual one-byte encoding of western Europe, to UTF-8.
std::string utf8_from_latin1(std::string_view text);

/// The order of the bytes of a UTF-16 unit.
enum class Utf16Order : std::uint8_t { little_endian, big_endian };
/// Returns the order that the byte order mark states, or, without one, that of the zero bytes of
/// the first two characters, if these are of ASCII; no value for text in another encoding.
std::optional<Utf16Order> utf16_order(std::string_view text);
/// Converts text from UTF-16 to UTF-8, without its byte order mark; half a character at the end is
/// left out, and a surrogate without its partner becomes U+FFFD.
std::string utf8_from_utf16(std::string_view text, Utf16Order order);

}  // namespace morphe::files
