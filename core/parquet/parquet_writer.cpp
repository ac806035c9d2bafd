#include "core/parquet/parquet_writer.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/files/little_endian.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::parquet {
namespace {

constexpr std::string_view kMagic = "PAR1";

}  // namespace

ParquetWriter::ParquetWriter(const std::filesystem::path& file, std::string name,
                             std::vector<Column> columns, std::vector<KeyValue> entries)
    : name_(std::move(name)),
      out_(file, std::ios::binary),
      columns_(std::move(columns)),
      entries_(std::move(entries)) {
  assert(!columns_.empty());
  for (const Column& column : columns_) chunks_.emplace_back(column);
  write(kMagic);
}

void ParquetWriter::write(std::string_view bytes) {
  errno = 0;
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out_.flush();
  if (!out_)
    throw InputError(fmt::format("{}: cannot be written: {}", name_, std::strerror(errno)));
  offset_ += bytes.size();
}

template <class Append>
void ParquetWriter::add_cell(const Append& append) {
  ColumnChunk& chunk = chunks_[column_];
  const std::size_t before = chunk.size();
  append(chunk);
  pending_bytes_ += chunk.size() - before;
  if (++column_ < columns_.size()) return;
  column_ = 0;
  ++rows_;
  if (pending_bytes_ >= kRowGroupBytes) write_row_group();
}

void ParquetWriter::add_boolean(bool value) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_boolean(value); });
}
void ParquetWriter::add_integer(std::int64_t value) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_integer(value); });
}
void ParquetWriter::add_number(double value) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_number(value); });
}
void ParquetWriter::add_text(std::string_view value) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_text(value); });
}
void ParquetWriter::add_null() {
  add_cell([&](ColumnChunk& chunk) { chunk.add_null(); });
}
void ParquetWriter::add_integers(std::span<const std::int64_t> values) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_integers(values); });
}
void ParquetWriter::add_numbers(std::span<const double> values) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_numbers(values); });
}
void ParquetWriter::add_texts(std::span<const std::string> values) {
  add_cell([&](ColumnChunk& chunk) { chunk.add_texts(values); });
}

void ParquetWriter::write_row_group() {
  RowGroup& group = groups_.emplace_back();
  group.rows = std::exchange(rows_, 0);
  for (ColumnChunk& chunk : chunks_) {
    const std::string body = chunk.page_body();
    const auto count = static_cast<std::int64_t>(chunk.value_count());
    const std::string header = page_header(count, static_cast<std::int64_t>(body.size()));
    group.chunks.push_back({static_cast<std::int64_t>(offset_),
                            static_cast<std::int64_t>(header.size() + body.size()), count});
    write(header);
    write(body);
    chunk.clear();
  }
  pending_bytes_ = 0;
}

void ParquetWriter::finish() {
  assert(column_ == 0);
  if (rows_ > 0) write_row_group();
  std::string end = file_metadata(columns_, groups_, entries_, "morphe");
  files::append_little_endian(end.size(), 4, end);
  write(end += kMagic);
  out_.close();
  if (!out_) throw InputError(fmt::format("{}: cannot be written", name_));
}

}  // namespace morphe::parquet
