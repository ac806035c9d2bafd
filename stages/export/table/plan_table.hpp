#pragma once

#include <filesystem>
#include <string>

#include "core/parquet/parquet_writer.hpp"
#include "stages/export/table/plan_columns.hpp"

namespace morphe::exports {

/// Returns the line of names of the table as CSV, with its line end.
std::string table_csv_head();
/// Returns a row as CSV (RFC 4180), with its line end. Numbers have the digits necessary to restore
/// the same double; an empty cell is unknown.
std::string table_csv_row(const PlanEntry& entry);

/// Writes the table as a Parquet file, in which null is unknown. The entry "units" of its metadata
/// maps the names of the columns to their units (JSON). Throws like ParquetWriter.
class PlanTableWriter {
 public:
  /// Creates the file; `name` is for messages.
  PlanTableWriter(const std::filesystem::path& file, const std::string& name);
  void add(const PlanEntry& entry);  ///< appends a row
  void finish() { writer_.finish(); }

 private:
  parquet::ParquetWriter writer_;
};

}  // namespace morphe::exports
