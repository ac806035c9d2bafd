#include "core/files/npy_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "core/files/little_endian.hpp"

namespace morphe::files {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kMaxHeader_bytes = 10000;  ///< the same limit as in numpy
constexpr std::size_t kMaxValueCount = std::size_t{1} << 27;

/// A parser of {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }.
struct HeaderParser {
  std::string_view rest;
  const NpyErrorHandler& fail;

  [[noreturn]] void fail_malformed() const {
    fail("is damaged: the numpy header is invalid");
    throw 0;  // not reached
  }
  bool take(std::string_view word) {
    while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.front())) != 0)
      rest.remove_prefix(1);
    if (!rest.starts_with(word)) return false;
    rest.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) fail_malformed();
  }
  std::string_view parse_string() {
    const char* const quote = take("'") ? "'" : "\"";
    if (*quote == '"') expect("\"");
    const std::size_t end = rest.find(quote);
    if (end == std::string_view::npos) fail_malformed();
    const std::string_view text = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return text;
  }
  std::size_t parse_integer() {
    take("");  // skips spaces
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc()) fail_malformed();
    rest.remove_prefix(end - rest.data());
    take("L");  // suffix of Python 2
    return value;
  }
  std::vector<std::size_t> parse_tuple() {
    std::vector<std::size_t> values;
    expect("(");
    while (!take(")")) {
      values.push_back(parse_integer());
      if (!take(",")) {
        expect(")");
        break;
      }
    }
    return values;
  }
};

void read_type(std::string_view type, NpyHeader& header, const NpyErrorHandler& fail) {
  if (type.size() >= 2 && type[1] == 'O')
    fail("contains Python objects; save it again as plain numbers or text (no dtype=object)");
  if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos)
    fail(fmt::format("has the unsupported type '{}'", type));
  std::size_t size = 0;
  const char* const end = type.data() + type.size();
  const auto [stop, error] = std::from_chars(type.data() + 2, end, size);
  const char kind = type[1];
  const bool sized = error == std::errc() && stop == end;
  const bool integer = size == 1 || size == 2 || size == 4 || size == 8;
  const bool known = (kind == 'b' && size == 1) || ((kind == 'i' || kind == 'u') && integer) ||
                     (kind == 'f' && (size == 2 || size == 4 || size == 8)) ||
                     ((kind == 'U' || kind == 'S') && size <= kMaxValueCount);
  if (!sized || !known) {
    fail(fmt::format(
        "has the unsupported type '{}'; use integers, floats of 2, 4 or 8 bytes, or text", type));
  }
  header.kind = kind;
  header.item_size = kind == 'U' ? 4 * size : size;
  header.big_endian = type[0] == '>';
}

std::size_t element_count(const std::vector<std::size_t>& shape, const NpyErrorHandler& fail) {
  if (std::ranges::find(shape, std::size_t{0}) != shape.end()) return 0;
  std::size_t count = 1;
  for (const std::size_t length : shape) {
    if (length > kMaxValueCount / count) fail("has more than 134 million values");
    count *= length;
  }
  return count;
}

}  // namespace

NpyHeader read_npy_header(std::string_view bytes, const NpyErrorHandler& fail) {
  if (!bytes.starts_with(kMagic)) fail("is not a .npy file");
  if (bytes.size() < kMagic.size() + 4) fail("ends within its header");
  const int version = static_cast<unsigned char>(bytes[kMagic.size()]);
  if (version < 1 || version > 3) fail(fmt::format("has the unsupported .npy version {}", version));
  const std::size_t size_bytes = version == 1 ? 2 : 4, begin = kMagic.size() + 2 + size_bytes;
  if (bytes.size() < begin) fail("ends within its header");
  const std::size_t length = read_little_endian(bytes, kMagic.size() + 2, size_bytes);
  if (length > kMaxHeader_bytes) fail("the header is too long");
  if (bytes.size() - begin < length) fail("ends within its header");

  NpyHeader header;
  header.data_offset = begin + length;
  HeaderParser literal{bytes.substr(begin, length), fail};
  std::optional<std::string_view> type;
  bool has_order = false, has_shape = false;
  literal.expect("{");
  while (!literal.take("}")) {
    const std::string_view key = literal.parse_string();
    literal.expect(":");
    if (key == "descr" && !type) {
      if (literal.take("["))
        fail("contains structured values; save each field as an array of its own");
      type = literal.parse_string();
    } else if (key == "fortran_order" && !has_order) {
      has_order = true;
      header.fortran_order = literal.take("True");
      if (!header.fortran_order) literal.expect("False");
    } else if (key == "shape" && !has_shape) {
      has_shape = true;
      header.shape = literal.parse_tuple();
    } else {
      literal.fail_malformed();
    }
    if (!literal.take(",")) {
      literal.expect("}");
      break;
    }
  }
  if (!type || !has_order || !has_shape) literal.fail_malformed();
  read_type(*type, header, fail);
  header.count = element_count(header.shape, fail);
  const std::size_t data_bytes = bytes.size() - header.data_offset;
  if (header.item_size > 0 && header.count > data_bytes / header.item_size) {
    fail(fmt::format("ends too early: {} bytes of data for {} values of {} bytes each", data_bytes,
                     header.count, header.item_size));
  }
  return header;
}

}  // namespace morphe::files
