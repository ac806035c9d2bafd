#include "core/parquet/column_chunk.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/files/little_endian.hpp"
#include "core/parquet/thrift_compact.hpp"

namespace morphe::parquet {
namespace {

constexpr std::uint8_t kNull = 0, kValue = 1;
constexpr std::uint8_t kEmptyList = 1, kNullElement = 2, kElement = 3;

void append_text(std::string_view value, std::string& bytes) {
  files::append_little_endian(value.size(), 4, bytes);
  bytes += value;
}

/// Returns values below 2^bit_width as packed bits, lowest first, in whole groups of eight values.
std::string packed_bits(std::span<const std::uint8_t> values, int bit_width) {
  const std::size_t groups = (values.size() + 7) / 8;
  std::string bytes(groups * bit_width, '\0');
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int bit = 0; bit < bit_width; ++bit) {
      const std::size_t at = i * bit_width + bit;
      if (values[i] >> bit & 1) bytes[at / 8] |= static_cast<char>(1 << at % 8);
    }
  return bytes;
}

}  // namespace

std::string encode_levels(std::span<const std::uint8_t> levels, int bit_width) {
  std::string runs;
  if (!levels.empty() && std::ranges::count(levels, levels.front()) == std::ssize(levels)) {
    append_varint(levels.size() << 1, runs);
    runs += static_cast<char>(levels.front());
  } else {
    append_varint((levels.size() + 7) / 8 << 1 | 1, runs);
    runs += packed_bits(levels, bit_width);
  }
  std::string bytes;
  append_text(runs, bytes);
  return bytes;
}

void ColumnChunk::define(std::uint8_t definition, bool is_first) {
  definition_.push_back(definition);
  if (is_list_) repetition_.push_back(is_first ? 0 : 1);
}

void ColumnChunk::append_number(double value) {
  if (type_ == ValueType::float32)
    files::append_little_endian(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4,
                                values_);
  else
    files::append_little_endian(std::bit_cast<std::uint64_t>(value), 8, values_);
}

void ColumnChunk::add_boolean(bool value) {
  assert(type_ == ValueType::boolean && !is_list_);
  define(kValue, true);
  values_ += static_cast<char>(value);
}

void ColumnChunk::add_integer(std::int64_t value) {
  assert(type_ == ValueType::int64 && !is_list_);
  define(kValue, true);
  files::append_little_endian(static_cast<std::uint64_t>(value), 8, values_);
}

void ColumnChunk::add_number(double value) {
  assert((type_ == ValueType::float32 || type_ == ValueType::float64) && !is_list_);
  if (std::isnan(value)) return add_null();
  define(kValue, true);
  append_number(value);
}

void ColumnChunk::add_text(std::string_view value) {
  assert(type_ == ValueType::text && !is_list_);
  define(kValue, true);
  append_text(value, values_);
}

void ColumnChunk::add_null() { define(kNull, true); }

template <class Values, class Append>
void ColumnChunk::add_list(const Values& values, const Append& append) {
  assert(is_list_);
  if (values.empty()) return define(kEmptyList, true);
  bool is_first = true;
  for (const auto& value : values) {
    define(append(value) ? kElement : kNullElement, is_first);
    is_first = false;
  }
}

void ColumnChunk::add_integers(std::span<const std::int64_t> values) {
  assert(type_ == ValueType::int64);
  add_list(values, [&](std::int64_t value) {
    files::append_little_endian(static_cast<std::uint64_t>(value), 8, values_);
    return true;
  });
}

void ColumnChunk::add_numbers(std::span<const double> values) {
  assert(type_ == ValueType::float32 || type_ == ValueType::float64);
  add_list(values, [&](double value) {
    if (std::isnan(value)) return false;
    append_number(value);
    return true;
  });
}

void ColumnChunk::add_texts(std::span<const std::string> values) {
  assert(type_ == ValueType::text);
  add_list(values, [&](const std::string& value) {
    append_text(value, values_);
    return true;
  });
}

std::string ColumnChunk::page_body() const {
  std::string body;
  if (is_list_) body += encode_levels(repetition_, 1);
  body += encode_levels(definition_, is_list_ ? 2 : 1);
  if (type_ != ValueType::boolean) return body + values_;
  const std::vector<std::uint8_t> bits(values_.begin(), values_.end());
  // Plain booleans are packed without a length; the last byte is padded.
  return body + packed_bits(bits, 1);
}

void ColumnChunk::clear() {
  values_.clear();
  definition_.clear();
  repetition_.clear();
}

}  // namespace morphe::parquet
