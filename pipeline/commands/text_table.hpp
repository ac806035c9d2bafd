#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace morphe::commands {

/// A table for display, with columns as wide as their contents, so that long names do not break the
/// layout.
struct TextTable {
  /// A column of the table.
  struct Column {
    /// Head of two lines.
    std::string top, subhead;
    /// True to align left (texts), false to align right (numbers).
    bool left = false;
    /// On a narrow terminal, columns with the largest priority are dropped first; 0 for columns
    /// that are kept.
    int drop_priority = 0;
  };
  /// A row of the table.
  struct Row {
    /// The texts of the cells.
    std::vector<std::string> cells;
    /// Lines below the row, indented.
    std::vector<std::string> lines;
  };
  /// The columns, from left to right.
  std::vector<Column> columns;
  /// The rows.
  std::vector<Row> rows;
};

/// Formats a table; every line ends in a newline. If `width` is not 0, lines are limited to it as
/// far as possible: columns are dropped (the last line names them), texts in the first column are
/// shortened, and lines are wrapped.
std::string table_text(const TextTable& table, std::size_t width);

/// Wraps a line at blanks if it is longer than `width` (not 0); continuation lines are indented
/// further.
std::string wrap_line(const std::string& text, std::size_t width, const std::string& indent);

/// Returns the width of standard output, 0 if it is not a terminal.
std::size_t terminal_width();

/// Returns the number of columns of a text, one for each code point.
std::size_t display_width(const std::string& text);

}  // namespace morphe::commands
