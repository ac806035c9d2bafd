#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// A text file of separated cells, line by line. A line ends at CR LF, LF or CR; the UTF-8 byte
/// order mark and trailing blank lines are removed. Cells are trimmed of spaces and tabs. Text that
/// is not UTF-8 is read as ISO 8859-1, with a note. Quoting is not supported.
struct CsvText {
  std::string file;
  std::vector<std::string> lines;  ///< line n of the file is lines[n - 1]
  std::vector<std::string> notes;  ///< sentences about unusual input that was accepted
  char separator = ',';

  std::vector<std::string_view> cells(std::size_t line) const;  ///< line counts from 1
  bool is_blank(std::size_t line) const;                        ///< true if no cell has text
  /// Throws InputError "FILE:LINE: KEY: message" (without KEY if it is empty).
  [[noreturn]] void fail(std::size_t line, std::string_view key, std::string_view message) const;
  /// Returns the finite decimal number that a cell consists of; else fails with the column as KEY.
  double number(std::size_t line, std::string_view column, std::string_view cell) const;
};

/// Returns the finite decimal number that a cell consists of, else nullopt.
std::optional<double> finite_number(std::string_view cell);

/// Reads a file; throws InputError if it cannot be read or contains zero bytes.
CsvText read_csv(const std::filesystem::path& file, char separator = ',');

}  // namespace morphe::files
