#include "stages/import/recording/named_columns.hpp"

#include <fmt/format.h>

namespace morphe::imports {

NamedColumns::NamedColumns(const files::CsvText& text, std::size_t header_line)
    : csv(text), line(header_line) {
  if (csv.lines.size() <= line)
    csv.fail(csv.lines.size(), "", "the file ends before the first row");
  for (const std::string_view cell : csv.cells(line)) {
    if (!at_.emplace(cell, names.size()).second) repeated_.emplace(cell);
    names.emplace_back(cell);
  }
}

std::size_t NamedColumns::at(std::string_view name) const {
  const auto column = at_.find(name);
  if (column == at_.end()) csv.fail(line, name, "the column is missing");
  if (repeated_.contains(name)) csv.fail(line, name, "the column appears twice");
  return column->second;
}

std::vector<std::size_t> NamedColumns::at(const std::vector<std::string>& columns) const {
  std::vector<std::size_t> indices;
  for (const std::string& name : columns) indices.push_back(at(name));
  return indices;
}

std::vector<std::string_view> NamedColumns::cells(std::size_t row_line) const {
  auto row = csv.cells(row_line);
  if (row.size() != names.size()) {
    csv.fail(row_line, "",
             fmt::format("the row has {} cells, the header has {}", row.size(), names.size()));
  }
  return row;
}

double NamedColumns::number_or_unknown(std::size_t row_line,
                                       const std::vector<std::string_view>& row,
                                       std::size_t column) const {
  return csv.number_or_unknown(row_line, names[column], row[column]);
}

double NamedColumns::number(std::size_t row_line, const std::vector<std::string_view>& row,
                            std::size_t column) const {
  return csv.number(row_line, names[column], row[column]);
}

}  // namespace morphe::imports
