#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a table by the names of its header. Its rows are the lines below the header.
struct NamedColumns {
  const files::CsvText& csv;       ///< the whole table
  std::size_t line = 0;            ///< line of the header
  std::vector<std::string> names;  ///< in order

  /// Reads the names of the columns from the header line.
  NamedColumns(const files::CsvText& text, std::size_t header_line);
  /// Returns the line of the first row.
  std::size_t first_row() const { return line + 1; }
  /// Returns the number of rows.
  std::size_t rows() const { return csv.lines.size() - line; }
  /// Returns true if there is a column of that name.
  bool has(std::string_view name) const { return at_.contains(name); }
  /// Returns the index of a column. Throws InputError "FILE:LINE: NAME: the column is missing".
  std::size_t at(std::string_view name) const;
  /// Returns the indices of several columns.
  std::vector<std::size_t> at(const std::vector<std::string>& wanted) const;
  /// Returns the cells of a row. Throws InputError unless there are as many as columns.
  std::vector<std::string_view> cells(std::size_t row_line) const;
  /// Returns the number in a cell. Throws InputError for a cell that is not a finite number.
  double number(std::size_t row_line, const std::vector<std::string_view>& row,
                std::size_t column) const;

 private:
  std::map<std::string, std::size_t, std::less<>> at_;
};

}  // namespace morphe::imports
