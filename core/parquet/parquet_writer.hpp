#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parquet/column.hpp"
#include "core/parquet/column_chunk.hpp"
#include "core/parquet/file_metadata.hpp"

namespace morphe::parquet {

/// Writes a table as a Parquet file: data pages of version 1 with plain values, not compressed, one
/// page per column and row group. Cells are given row by row, one per column, in the order of the
/// columns; a row group is written when its cells fill `kRowGroupBytes`, so that memory does not
/// grow with the table. The same cells give the same bytes.
///
/// The file is complete after finish(). Functions that write throw InputError "NAME: cannot be
/// written: …", with the name given for messages, for example on a full disk.
class ParquetWriter {
 public:
  /// Bytes of cells after which a row group is written.
  static constexpr std::size_t kRowGroupBytes = 8 << 20;

  /// Creates the file, in place of an existing one. There is at least one column.
  ParquetWriter(const std::filesystem::path& file, std::string name, std::vector<Column> columns,
                std::vector<KeyValue> entries = {});

  /// Appends the next cell of the row (ColumnChunk); the last one completes the row.
  void add_boolean(bool value);
  void add_integer(std::int64_t value);
  void add_number(double value);
  void add_text(std::string_view value);
  void add_null();
  void add_integers(std::span<const std::int64_t> values);
  void add_numbers(std::span<const double> values);
  void add_texts(std::span<const std::string> values);

  /// Returns the number of bytes so far, without the metadata at the end; an upper bound while
  /// cells wait for their row group.
  std::uint64_t size() const { return offset_ + pending_bytes_; }
  /// Writes the last row group and the metadata. All rows are complete.
  void finish();

 private:
  template <class Append>
  void add_cell(const Append& append);
  void write(std::string_view bytes);
  void write_row_group();

  std::string name_;
  std::ofstream out_;
  std::vector<Column> columns_;
  std::vector<KeyValue> entries_;
  std::vector<ColumnChunk> chunks_;
  std::vector<RowGroup> groups_;
  std::size_t column_ = 0;  ///< of the next cell
  std::int64_t rows_ = 0;   ///< in the row group that is not yet written
  std::uint64_t offset_ = 0, pending_bytes_ = 0;
};

}  // namespace morphe::parquet
