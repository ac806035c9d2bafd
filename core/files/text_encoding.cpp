#include "core/files/text_encoding.hpp"

namespace morphe::files {

bool is_utf8(std::string_view text) {
  // Smallest code point by number of continuation bytes.
  static constexpr std::uint32_t kMinCode[] = {0, 0x80, 0x800, 0x10000};
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i++]);
    if (first < 0x80) continue;
    if (first < 0xc0 || first > 0xf4) return false;
    const std::size_t more = first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    if (more > text.size() - i) return false;
    std::uint32_t code = first & (0x3f >> more);
    for (std::size_t end = i + more; i < end; ++i) {
      const auto next = static_cast<unsigned char>(text[i]);
      if ((next & 0xc0) != 0x80) return false;
      code = code << 6 | (next & 0x3f);
    }
    if (code < kMinCode[more] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return false;
  }
  return true;
}

void append_utf8(std::uint32_t point, std::string& text) {
  constexpr std::uint32_t kLeadingBits[] = {0, 0xc0, 0xe0, 0xf0};
  const int trailing = point < 0x80 ? 0 : point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  text += static_cast<char>(kLeadingBits[trailing] | point >> 6 * trailing);
  for (int k = trailing - 1; k >= 0; --k) text += static_cast<char>(0x80 | (point >> 6 * k & 0x3f));
}

std::string utf8_from_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) append_utf8(static_cast<unsigned char>(c), utf8);
  return utf8;
}

std::optional<Utf16Order> utf16_order(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.size() < 4 || text.starts_with("\xFF\xFE\0\0"sv)) return std::nullopt;  // UTF-32
  if (text.starts_with("\xFF\xFE"sv)) return Utf16Order::little_endian;
  if (text.starts_with("\xFE\xFF"sv)) return Utf16Order::big_endian;
  const auto is_ascii = [&](std::size_t i) { return text[i] >= '\t' && text[i] < '\x7f'; };
  if (is_ascii(0) && text[1] == 0 && is_ascii(2) && text[3] == 0) return Utf16Order::little_endian;
  if (text[0] == 0 && is_ascii(1) && text[2] == 0 && is_ascii(3)) return Utf16Order::big_endian;
  return std::nullopt;
}

std::string utf8_from_utf16(std::string_view text, Utf16Order order) {
  constexpr std::uint32_t kReplacement = 0xfffd, kByteOrderMark = 0xfeff;
  const auto unit = [&](std::size_t i) {
    const std::uint32_t a = static_cast<unsigned char>(text[i]),
                        b = static_cast<unsigned char>(text[i + 1]);
    return order == Utf16Order::little_endian ? b << 8 | a : a << 8 | b;
  };
  std::string utf8;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    std::uint32_t point = unit(i);
    if (i == 0 && point == kByteOrderMark) continue;
    if (point >= 0xd800 && point < 0xe000) {
      const std::uint32_t low = i + 3 < text.size() ? unit(i + 2) : 0;
      const bool paired = point < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      point = paired ? 0x10000 + ((point - 0xd800) << 10 | (low - 0xdc00)) : kReplacement;
      if (paired) i += 2;
    }
    append_utf8(point, utf8);
  }
  return utf8;
}

}  // namespace morphe::files
