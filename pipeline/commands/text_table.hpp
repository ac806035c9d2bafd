#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace morphe::commands {

/// A table for people: columns as wide as what stands in them, so that no name breaks it.
struct TextTable {
  struct Column {
    std::string top, below;  ///< head of two lines
    bool left = false;       ///< texts stand left, numbers right
    int spare = 0;           ///< where the terminal is narrow the largest goes first; 0: stays
  };
  struct Row {
    std::vector<std::string> cells;
    std::vector<std::string> lines;  ///< below the row, indented
  };
  std::vector<Column> columns;
  std::vector<Row> rows;
};

/// Every line ends in a newline. Where `width` is not 0, no line is longer: columns are left out
/// (the last line says which), what stands in the first is shortened, lines are folded.
std::string table_text(const TextTable& table, std::size_t width);

/// A line, folded at blanks where it is longer than `width` (not 0); what goes on is indented
/// further.
std::string folded(const std::string& text, std::size_t width, const std::string& indent);

/// Of standard output; 0 if that is no terminal.
std::size_t terminal_width();

/// Columns that a text takes, each code point one.
std::size_t width_of(const std::string& text);

}  // namespace morphe::commands
