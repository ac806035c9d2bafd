#include "stages/export/table/plan_table.hpp"

#include <fmt/format.h>

#include "stages/export/table/csv_cell.hpp"

namespace morphe::exports {
namespace {

std::vector<parquet::Column> parquet_columns() {
  std::vector<parquet::Column> columns;
  for (const PlanColumn& column : plan_columns())
    columns.push_back({std::string(column.name), column.type});
  return columns;
}

std::vector<parquet::KeyValue> units_entry() {
  std::string json;
  for (const PlanColumn& column : plan_columns())
    if (!column.unit.empty())
      json += fmt::format("{}\"{}\": \"{}\"", json.empty() ? "" : ", ", column.name, column.unit);
  return {{"units", "{" + json + "}"}};
}

/// Writes a cell as CSV.
struct CsvText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return csv_cell(value); }
};

/// Adds a cell to a Parquet file.
struct ParquetCell {
  parquet::ParquetWriter& writer;
  void operator()(std::monostate) const { writer.add_null(); }
  void operator()(bool value) const { writer.add_boolean(value); }
  void operator()(std::int64_t value) const { writer.add_integer(value); }
  void operator()(double value) const { writer.add_number(value); }
  void operator()(const std::string& value) const { writer.add_text(value); }
};

}  // namespace

std::string table_csv_head() {
  std::string line;
  for (const PlanColumn& column : plan_columns())
    line += fmt::format("{}{}", line.empty() ? "" : ",", column.name);
  return line + "\n";
}

std::string table_csv_row(const PlanEntry& entry) {
  std::string line;
  for (const PlanColumn& column : plan_columns()) {
    if (&column != plan_columns().data()) line += ",";
    line += std::visit(CsvText{}, column.value(entry));
  }
  return line + "\n";
}

PlanTableWriter::PlanTableWriter(const std::filesystem::path& file, const std::string& name)
    : writer_(file, name, parquet_columns(), units_entry()) {}

void PlanTableWriter::add(const PlanEntry& entry) {
  for (const PlanColumn& column : plan_columns())
    std::visit(ParquetCell{writer_}, column.value(entry));
}

}  // namespace morphe::exports
