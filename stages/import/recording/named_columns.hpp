#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a table by the names of its header. Its rows are the lines below.
struct NamedColumns {
  const files::CsvText& csv;
  std::size_t line = 0;            ///< of the header
  std::vector<std::string> names;  ///< in order

  NamedColumns(const files::CsvText& text, std::size_t header_line);
  std::size_t first_row() const { return line + 1; }
  std::size_t rows() const { return csv.lines.size() - line; }
  bool has(std::string_view name) const { return at_.contains(name); }
  /// InputError "FILE:LINE: NAME: the column is missing".
  std::size_t at(std::string_view name) const;
  std::vector<std::size_t> at(const std::vector<std::string>& wanted) const;
  /// The cells of a row; InputError unless there are as many as columns.
  std::vector<std::string_view> cells(std::size_t row_line) const;
  /// InputError for a cell that is no finite number.
  double number(std::size_t row_line, const std::vector<std::string_view>& row,
                std::size_t column) const;

 private:
  std::map<std::string, std::size_t, std::less<>> at_;
};

}  // namespace morphe::imports
