#include "stages/import/csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "pipeline/motion/input_error.hpp"

namespace morphe {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

CsvText read_csv(const std::filesystem::path& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error)) {
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  }
  CsvText csv{file.string(), {}};
  for (std::string line; std::getline(stream, line);) {
    if (csv.lines.empty() && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (line.ends_with('\r')) line.pop_back();
    csv.lines.push_back(std::move(line));
  }
  if (stream.bad()) throw InputError(fmt::format("{}: cannot be read", file.string()));
  while (!csv.lines.empty() && trimmed(csv.lines.back()).empty()) csv.lines.pop_back();
  return csv;
}

std::vector<std::string_view> CsvText::cells(std::size_t line) const {
  std::vector<std::string_view> cells;
  std::string_view rest = lines[line - 1];
  while (true) {
    const std::size_t comma = rest.find(',');
    cells.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    rest.remove_prefix(comma + 1);
  }
}

void CsvText::fail(std::size_t line, std::string_view key, std::string_view message) const {
  throw InputError(key.empty() ? fmt::format("{}:{}: {}", file, line, message)
                               : fmt::format("{}:{}: {}: {}", file, line, key, message));
}

double CsvText::number(std::size_t line, std::string_view column, std::string_view cell) const {
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    fail(line, column, fmt::format("must be a number, not '{}'", cell));
  }
  return value;
}

}  // namespace morphe
