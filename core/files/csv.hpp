#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// A text file of separated cells, line by line. A line ends at CR LF, LF, CR or CR CR LF; the byte
/// order mark and trailing blank lines are removed. Cells are trimmed of spaces and tabs. UTF-16 is
/// converted; other text that is not UTF-8 is read as ISO 8859-1; both are noted.
struct CsvText {
  std::string file;
  std::vector<std::string> lines;  ///< line n of the file is lines[n - 1]
  std::vector<std::string> notes;  ///< sentences about unusual input that was accepted
  char separator = ',';
  bool decimal_comma = false;  ///< true if numbers have a decimal comma
  bool ends_open = false;      ///< true if the last line has no line end

  std::vector<std::string_view> cells(std::size_t line) const;  ///< line counts from 1
  bool is_blank(std::size_t line) const;                        ///< true if no cell has text
  /// Returns the first line from `line` on that has text; lines.size() + 1 without one.
  std::size_t filled_line(std::size_t line) const;
  /// Throws InputError "FILE:LINE: KEY: message" (without KEY if it is empty).
  [[noreturn]] void fail(std::size_t line, std::string_view key, std::string_view message) const;
  /// Returns the finite decimal number that a cell consists of, else nullopt. A decimal point is no
  /// number if the file has decimal commas, nor is a comma if it has not.
  std::optional<double> value(std::string_view cell) const;
  /// Returns that number; without one, fails with the column as KEY.
  double number(std::size_t line, std::string_view column, std::string_view cell) const;
  /// Returns that number, NaN for a missing value; otherwise fails like number().
  double number_or_unknown(std::size_t line, std::string_view column, std::string_view cell) const;
};

/// Returns the finite decimal number that a cell consists of, else nullopt.
std::optional<double> finite_number(std::string_view cell);

/// Returns true if a cell denotes a missing number, as programs write it: empty, nan and inf of any
/// case and sign (also 1.#IND, nan(ind)), NA, N/A, null, none, an error of a spreadsheet (#N/A), or
/// only one of the characters - . * ? repeated.
bool is_missing_value(std::string_view cell);

/// Reads a file; throws InputError if it cannot be read or contains zero bytes.
CsvText read_csv(const std::filesystem::path& file, char separator = ',');

/// Returns the lines of a text as read_csv() does. `file` is its name in messages.
CsvText csv_from_text(const std::string& file, std::string text, char separator = ',');

}  // namespace morphe::files
