#include "core/files/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "core/files/text_encoding.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

CsvText read_csv(const std::filesystem::path& file, char separator) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": cannot be read");
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  CsvText csv{file.string(), {}, {}, separator};
  if (text.find('\0') != std::string::npos)
    throw InputError(csv.file + ": contains null bytes: not a text file, or not UTF-8");
  if (!is_utf8(text)) {
    text = utf8_from_latin1(text);
    csv.notes.push_back("the text is not UTF-8; assumed ISO 8859-1");
  }
  std::set<std::string_view> line_ends;
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find_first_of("\r\n"), rest.size());
    csv.lines.emplace_back(rest.substr(0, length));
    rest.remove_prefix(length);
    const std::string_view end = rest.substr(0, rest.starts_with("\r\n") ? 2 : 1);
    if (!end.empty()) line_ends.insert(end);
    rest.remove_prefix(end.size());
  }
  if (line_ends.size() > 1) csv.notes.push_back("mixed line endings; all are accepted");
  while (!csv.lines.empty() && csv.is_blank(csv.lines.size())) csv.lines.pop_back();
  return csv;
}

bool CsvText::is_blank(std::size_t line) const {
  return lines[line - 1].find_first_not_of(std::string{separator, ' ', '\t'}) == std::string::npos;
}

std::vector<std::string_view> CsvText::cells(std::size_t line) const {
  std::vector<std::string_view> cells;
  std::string_view rest = lines[line - 1];
  while (true) {
    const std::size_t end = rest.find(separator);
    cells.push_back(trim(rest.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    rest.remove_prefix(end + 1);
  }
}

void CsvText::fail(std::size_t line, std::string_view key, std::string_view message) const {
  throw InputError(key.empty() ? fmt::format("{}:{}: {}", file, line, message)
                               : fmt::format("{}:{}: {}: {}", file, line, key, message));
}

double CsvText::number(std::size_t line, std::string_view column, std::string_view cell) const {
  const std::optional<double> value = finite_number(cell);
  if (!value) fail(line, column, fmt::format("must be a number, not '{}'", cell));
  return *value;
}

std::optional<double> finite_number(std::string_view cell) {
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace morphe::files
