#include "core/files/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/files/text_encoding.hpp"

namespace morphe::files {
namespace {

/// Returns the number of bytes of the character that a byte begins, 1 if it begins no character.
std::size_t utf8_length(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xc2 || byte > 0xf4 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

std::uint32_t code_of(std::string_view letter) {
  const auto first = static_cast<unsigned char>(letter[0]);
  if (letter.size() == 1) return first;
  std::uint32_t code = first & (0x7fu >> letter.size());
  for (const char c : letter.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3fu);
  return code;
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string make_printable(std::string_view text, std::string_view allowed) {
  std::string shown;
  while (!text.empty()) {
    std::string_view letter = text.substr(0, utf8_length(text[0]));
    if (!is_utf8(letter)) {
      letter = text.substr(0, 1);
      if (static_cast<unsigned char>(letter[0]) >= 0x80) {
        shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(letter[0]));
        text.remove_prefix(1);
        continue;
      }
    }
    const std::uint32_t code = code_of(letter);
    if (is_control(code) &&
        (letter.size() > 1 || allowed.find(letter[0]) == std::string_view::npos))
      shown += fmt::format("\\u{:04x}", code);
    else
      shown += letter;
    text.remove_prefix(letter.size());
  }
  return shown;
}

bool is_printable(std::string_view text) { return make_printable(text) == text; }

std::size_t incomplete_utf8_bytes(std::string_view text) {
  const std::size_t max_tail_bytes = std::min<std::size_t>(text.size(), 3);
  for (std::size_t tail_bytes = 1; tail_bytes <= max_tail_bytes; ++tail_bytes) {
    const char c = text[text.size() - tail_bytes];
    if (static_cast<unsigned char>(c) < 0x80) return 0;
    const std::size_t bytes = utf8_length(c);
    if (bytes > 1) return bytes > tail_bytes ? tail_bytes : 0;
  }
  return 0;
}

}  // namespace morphe::files
