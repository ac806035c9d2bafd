#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a table by the names in its header. Its rows are the lines below the header.
struct NamedColumns {
  const files::CsvText& csv;       ///< must outlive this
  std::size_t line = 0;            ///< number of the header's line, from 1
  std::vector<std::string> names;  ///< in the order of the columns

  NamedColumns(const files::CsvText& text, std::size_t header_line);
  std::size_t first_row() const { return line + 1; }            ///< number of the first row's line
  std::size_t rows() const { return csv.lines.size() - line; }  ///< number of rows
  bool has(std::string_view name) const { return at_.contains(name); }
  /// Returns the index of a column. Throws InputError "FILE:LINE: NAME: the column is missing", or
  /// "… appears twice".
  std::size_t at(std::string_view name) const;
  std::vector<std::size_t> at(const std::vector<std::string>& columns) const;
  /// Returns the cells of a row. Throws InputError unless there are as many as columns.
  std::vector<std::string_view> cells(std::size_t row_line) const;
  /// Returns the number in a cell of `row`, line `row_line`, NaN if it is missing. Throws
  /// InputError for other text.
  double number_or_unknown(std::size_t row_line, const std::vector<std::string_view>& row,
                           std::size_t column) const;
  /// Returns the number in a cell in the same way. Throws InputError if it is missing.
  double number(std::size_t row_line, const std::vector<std::string_view>& row,
                std::size_t column) const;

 private:
  std::set<std::string, std::less<>> repeated_;
  std::map<std::string, std::size_t, std::less<>> at_;
};

}  // namespace morphe::imports
