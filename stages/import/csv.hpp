#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe {

/// A comma-separated text file, line by line: UTF-8 mark and carriage returns removed, blank lines
/// at the end dropped. Cells are trimmed of spaces. Quoting is not understood.
struct CsvText {
  std::string file;
  std::vector<std::string> lines;  ///< line n of the file is lines[n - 1]

  std::vector<std::string_view> cells(std::size_t line) const;  ///< line counts from 1
  /// Throws InputError "FILE:LINE: KEY: message" (without KEY if it is empty).
  [[noreturn]] void fail(std::size_t line, std::string_view key, std::string_view message) const;
  /// A finite decimal number, or fails naming the column.
  double number(std::size_t line, std::string_view column, std::string_view cell) const;
};

/// InputError if the file cannot be read.
CsvText read_csv(const std::filesystem::path& file);

}  // namespace morphe
