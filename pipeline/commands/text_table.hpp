#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace morphe::commands {

/// A table with columns as wide as their contents, so that long names do not break the layout.
struct TextTable {
  /// A column, with a head of two lines.
  struct Column {
    std::string top, subhead;
    bool left = false;      ///< true to align left (texts), false to align right (numbers)
    int drop_priority = 0;  ///< columns of large values are dropped first, of 0 never
  };
  /// A row, with a text for each column and the indented lines below it.
  struct Row {
    std::vector<std::string> cells, lines;
  };
  std::vector<Column> columns;
  std::vector<Row> rows;
};

/// Returns the table as text. If `width` is not 0, lines are limited to it as far as possible by
/// dropping columns (the last line names them), shortening texts in the first, and wrapping lines.
std::string table_text(const TextTable& table, std::size_t width);

/// Shortens a text wider than `max_width` to its first and last code points with … between them.
std::string shorten(const std::string& text, std::size_t max_width);

/// Returns a text as a line that begins with `indent`, wrapped at blanks if it is longer than
/// `width` (0: never wrapped). Further lines are indented by four more blanks.
std::string wrap_line(const std::string& text, std::size_t width, const std::string& indent);

/// Returns the width of standard output, 0 if it is not a terminal.
std::size_t terminal_width();

/// Returns the width of a text in columns, one for each code point.
std::size_t display_width(const std::string& text);

}  // namespace morphe::commands
