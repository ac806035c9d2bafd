#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// A text file of separated cells, line by line. A line ends at CR LF, LF or CR; the UTF-8 mark is
/// removed and lines without anything but separators are dropped at the end. Cells are trimmed of
/// spaces. What is not UTF-8 is taken as ISO 8859-1 and reported. Quoting is not understood.
struct CsvText {
  std::string file;
  std::vector<std::string> lines;    ///< line n of the file is lines[n - 1]
  std::vector<std::string> reports;  ///< sentences about what was unusual but understood
  char separator = ',';

  std::vector<std::string_view> cells(std::size_t line) const;  ///< line counts from 1
  bool blank(std::size_t line) const;                           ///< holds no cell with text
  /// Throws InputError "FILE:LINE: KEY: message" (without KEY if it is empty).
  [[noreturn]] void fail(std::size_t line, std::string_view key, std::string_view message) const;
  /// A finite decimal number, or fails naming the column.
  double number(std::size_t line, std::string_view column, std::string_view cell) const;
};

/// A finite decimal number, if the cell is one.
std::optional<double> finite_number(std::string_view cell);

/// InputError if the file cannot be read or holds bytes of zero.
CsvText read_csv(const std::filesystem::path& file, char separator = ',');

}  // namespace morphe::files
