#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/files/little_endian.hpp"
#include "core/files/npy_header.hpp"
#include "core/files/npz_file.hpp"
#include "core/files/text_encoding.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

constexpr std::size_t kAlignment_bytes = 64;  ///< of the values, as in numpy

/// Converts a number of half precision: 1 sign, 5 exponent, 10 fraction bits.
double half_to_double(std::uint64_t bits) {
  const int exponent = bits >> 10 & 31;
  const double fraction = static_cast<double>(bits & 1023);
  const double sign = (bits & 0x8000) != 0 ? -1 : 1;
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  if (exponent == 31) return fraction == 0 ? sign * HUGE_VAL : std::nan("");
  return sign * std::ldexp(1024 + fraction, exponent - 25);
}

double value_of(std::uint64_t bits, char kind, std::size_t size) {
  if (kind == 'f') {
    if (size == 2) return half_to_double(bits);
    if (size == 4) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    return std::bit_cast<double>(bits);
  }
  if (kind == 'b') return bits == 0 ? 0 : 1;
  if (kind == 'u' || size == 0) return static_cast<double>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (8 * size - 1);
  return static_cast<double>(static_cast<std::int64_t>((bits ^ sign) - sign));
}

std::vector<std::uint32_t> code_points(std::string_view text) {
  std::vector<std::uint32_t> points;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0) == 0x80 && !points.empty())
      points.back() = points.back() << 6 | (byte & 0x3F);
    else
      points.push_back(byte < 0x80 ? byte : byte < 0xE0 ? byte & 0x1F : byte & 0x0F);
  }
  return points;
}

/// Returns the offset in the file of the k-th value, counted with the last index fastest.
std::size_t offset_of(std::size_t k, const NpyHeader& header) {
  std::size_t index = header.fortran_order ? 0 : k, stride = header.count;
  for (std::size_t d = header.shape.size(); header.fortran_order && d-- > 0;) {
    stride /= header.shape[d];
    index += k % header.shape[d] * stride;
    k /= header.shape[d];
  }
  return header.data_offset + index * header.item_size;
}

struct ValueReader {
  std::string_view bytes;
  const NpyHeader& header;
  const NpyErrorHandler& fail;

  std::uint64_t bits(std::size_t begin, std::size_t size) const {
    std::uint64_t value = read_little_endian(bytes, begin, size);
    if (!header.big_endian) return value;
    std::uint64_t swapped = 0;
    for (std::size_t k = 0; k < size; ++k, value >>= 8) swapped = swapped << 8 | (value & 0xFF);
    return swapped;
  }
  double number(std::size_t k) const {
    return value_of(bits(offset_of(k, header), header.item_size), header.kind, header.item_size);
  }
  std::string text(std::size_t k) const {
    const std::size_t offset = offset_of(k, header);
    std::string text;
    if (header.kind == 'S') {
      text = bytes.substr(offset, header.item_size);
      text.erase(text.find_last_not_of('\0') + 1);
      return is_utf8(text) ? text : utf8_from_latin1(text);
    }
    for (std::size_t b = 0; b < header.item_size; b += 4) {
      const std::uint64_t point = bits(offset + b, 4);
      if (point > 0x10FFFF || (point >= 0xD800 && point < 0xE000))
        fail("is damaged: the text has an invalid character");
      append_utf8(static_cast<std::uint32_t>(point), text);
    }
    text.erase(text.find_last_not_of('\0') + 1);
    return text;
  }
};

}  // namespace

std::string shape_text(const std::vector<std::size_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

NpyArray read_npy(std::string_view bytes, const std::string& file, const std::string& key) {
  const NpyErrorHandler fail = [&](const std::string& what) {
    throw InputError(fmt::format("{}: {}: {}", file, key, what));
  };
  const NpyHeader header = read_npy_header(bytes, fail);
  const ValueReader values{bytes, header, fail};
  NpyArray array;
  array.name = key;
  array.shape = header.shape;
  const bool text = header.kind == 'U' || header.kind == 'S';
  array.kind = text ? NpyKind::text : header.kind == 'f' ? NpyKind::floating : NpyKind::integer;
  for (std::size_t k = 0; k < header.count; ++k)
    if (text)
      array.text.push_back(values.text(k));
    else
      array.values.push_back(values.number(k));
  return array;
}

std::string npy_bytes(const NpyArray& array) {
  std::size_t longest = 1;
  std::vector<std::vector<std::uint32_t>> texts;
  for (const std::string& text : array.text) {
    texts.push_back(code_points(text));
    longest = std::max(longest, texts.back().size());
  }
  const std::string type = array.kind == NpyKind::text      ? fmt::format("<U{}", longest)
                           : array.kind == NpyKind::integer ? "<i8"
                                                            : "<f8";
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type,
                                   shape_text(array.shape));
  const std::size_t prefix_bytes = 10;  // magic, version, length of the header
  header.append(kAlignment_bytes - (prefix_bytes + header.size() + 1) % kAlignment_bytes, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  append_little_endian(header.size(), 2, bytes);
  bytes += header;
  for (const double value : array.values) {
    append_little_endian(array.kind == NpyKind::integer
                             ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value))
                             : std::bit_cast<std::uint64_t>(value),
                         8, bytes);
  }
  for (const auto& points : texts)
    for (std::size_t k = 0; k < longest; ++k)
      append_little_endian(k < points.size() ? points[k] : 0, 4, bytes);
  return bytes;
}

}  // namespace morphe::files
