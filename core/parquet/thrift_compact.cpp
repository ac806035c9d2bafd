#include "core/parquet/thrift_compact.hpp"

#include <cassert>

namespace morphe::parquet {
namespace {

constexpr int kMaxShortStep = 15;  ///< of ids that share a byte with the type
constexpr std::size_t kMaxShortList = 14;

/// Maps integers to unsigned ones such that small magnitudes stay small.
std::uint64_t zigzag(std::int64_t value) {
  return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}

}  // namespace

void append_varint(std::uint64_t value, std::string& bytes) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(0x80 | (value & 0x7F));
  bytes += static_cast<char>(value);
}

void ThriftWriter::field(int id, Type type) {
  const int step = id - last_id_.back();
  assert(step > 0 && step <= kMaxShortStep);
  bytes_ += static_cast<char>(step << 4 | static_cast<int>(type));
  last_id_.back() = id;
}

void ThriftWriter::integer(int id, Type type, std::int64_t value) {
  field(id, type);
  integer_element(value);
}

void ThriftWriter::text(int id, std::string_view value) {
  field(id, Type::binary);
  text_element(value);
}

void ThriftWriter::begin_list(int id, Type element, std::size_t size) {
  field(id, Type::list);
  const bool is_short = size <= kMaxShortList;
  bytes_ += static_cast<char>((is_short ? size : 0xF) << 4 | static_cast<std::size_t>(element));
  if (!is_short) append_varint(size, bytes_);
}

void ThriftWriter::integer_element(std::int64_t value) { append_varint(zigzag(value), bytes_); }

void ThriftWriter::text_element(std::string_view value) {
  append_varint(value.size(), bytes_);
  bytes_ += value;
}

void ThriftWriter::begin_struct(int id) {
  field(id, Type::structure);
  begin_struct_element();
}

void ThriftWriter::begin_struct_element() { last_id_.push_back(0); }

void ThriftWriter::end_struct() {
  bytes_ += '\0';
  last_id_.pop_back();
}

}  // namespace morphe::parquet
