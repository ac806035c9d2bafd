#include "core/parquet/file_metadata.hpp"

#include "core/parquet/thrift_compact.hpp"

namespace morphe::parquet {
namespace {

// Numbers of the enumerations and ids of the fields are those of parquet.thrift.
using Type = ThriftWriter::Type;

constexpr int kOptional = 1, kRepeated = 2;
constexpr int kConvertedUtf8 = 0, kConvertedList = 3;
constexpr int kLogicalString = 1, kLogicalList = 3;
constexpr int kPlain = 0, kRunLength = 3;

int physical_type(ValueType type) {
  switch (type) {
    case ValueType::boolean:
      return 0;
    case ValueType::int64:
      return 2;
    case ValueType::float32:
      return 4;
    case ValueType::float64:
      return 5;
    case ValueType::text:
      return 6;
  }
  return 6;
}

void write_logical_type(ThriftWriter& out, int converted, int logical) {
  out.integer(6, Type::i32, converted);
  out.begin_struct(10);
  out.begin_struct(logical);
  out.end_struct();
  out.end_struct();
}

void write_leaf(ThriftWriter& out, const std::string& name, ValueType type) {
  out.begin_struct_element();
  out.integer(1, Type::i32, physical_type(type));
  out.integer(3, Type::i32, kOptional);
  out.text(4, name);
  if (type == ValueType::text) write_logical_type(out, kConvertedUtf8, kLogicalString);
  out.end_struct();
}

/// Writes the three levels of a list: the column, its repeated group "list", the "element".
void write_list(ThriftWriter& out, const Column& column) {
  out.begin_struct_element();
  out.integer(3, Type::i32, kOptional);
  out.text(4, column.name);
  out.integer(5, Type::i32, 1);
  write_logical_type(out, kConvertedList, kLogicalList);
  out.end_struct();
  out.begin_struct_element();
  out.integer(3, Type::i32, kRepeated);
  out.text(4, "list");
  out.integer(5, Type::i32, 1);
  out.end_struct();
  write_leaf(out, "element", column.type);
}

void write_schema(ThriftWriter& out, const std::vector<Column>& columns) {
  std::size_t elements = 1;
  for (const Column& column : columns) elements += column.is_list ? 3 : 1;
  out.begin_list(2, Type::structure, elements);
  out.begin_struct_element();
  out.text(4, "schema");
  out.integer(5, Type::i32, static_cast<std::int64_t>(columns.size()));
  out.end_struct();
  for (const Column& column : columns) {
    if (column.is_list)
      write_list(out, column);
    else
      write_leaf(out, column.name, column.type);
  }
}

void write_chunk(ThriftWriter& out, const Column& column, const ChunkPlace& place) {
  out.begin_struct_element();
  out.integer(2, Type::i64, 0);  // file_offset, of metadata that are not in the footer
  out.begin_struct(3);
  out.integer(1, Type::i32, physical_type(column.type));
  out.begin_list(2, Type::i32, 2);
  out.integer_element(kPlain);
  out.integer_element(kRunLength);
  out.begin_list(3, Type::binary, column.is_list ? 3 : 1);
  out.text_element(column.name);
  if (column.is_list) {
    out.text_element("list");
    out.text_element("element");
  }
  out.integer(4, Type::i32, 0);  // not compressed
  out.integer(5, Type::i64, place.value_count);
  out.integer(6, Type::i64, place.size);
  out.integer(7, Type::i64, place.size);
  out.integer(9, Type::i64, place.offset);
  out.end_struct();
  out.end_struct();
}

void write_row_group(ThriftWriter& out, const std::vector<Column>& columns, const RowGroup& group) {
  std::int64_t bytes = 0;
  for (const ChunkPlace& place : group.chunks) bytes += place.size;
  out.begin_struct_element();
  out.begin_list(1, Type::structure, columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) write_chunk(out, columns[c], group.chunks[c]);
  out.integer(2, Type::i64, bytes);
  out.integer(3, Type::i64, group.rows);
  out.integer(5, Type::i64, group.chunks.front().offset);
  out.integer(6, Type::i64, bytes);
  out.end_struct();
}

}  // namespace

std::string page_header(std::int64_t value_count, std::int64_t body_bytes) {
  ThriftWriter out;
  out.integer(1, Type::i32, 0);  // data page of version 1
  out.integer(2, Type::i32, body_bytes);
  out.integer(3, Type::i32, body_bytes);
  out.begin_struct(5);
  out.integer(1, Type::i32, value_count);
  out.integer(2, Type::i32, kPlain);
  out.integer(3, Type::i32, kRunLength);
  out.integer(4, Type::i32, kRunLength);
  out.end_struct();
  out.end_struct();
  return out.bytes();
}

std::string file_metadata(const std::vector<Column>& columns, const std::vector<RowGroup>& groups,
                          const std::vector<KeyValue>& entries, const std::string& created_by) {
  constexpr int kVersion = 2;
  ThriftWriter out;
  out.integer(1, Type::i32, kVersion);
  write_schema(out, columns);
  std::int64_t rows = 0;
  for (const RowGroup& group : groups) rows += group.rows;
  out.integer(3, Type::i64, rows);
  out.begin_list(4, Type::structure, groups.size());
  for (const RowGroup& group : groups) write_row_group(out, columns, group);
  if (!entries.empty()) {
    out.begin_list(5, Type::structure, entries.size());
    for (const KeyValue& entry : entries) {
      out.begin_struct_element();
      out.text(1, entry.key);
      out.text(2, entry.value);
      out.end_struct();
    }
  }
  out.text(6, created_by);
  out.end_struct();
  return out.bytes();
}

}  // namespace morphe::parquet
