#include "core/files/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "core/files/text_encoding.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Removes one sign at the front of a text.
std::string_view without_sign(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text;
}

/// Returns the size of the line end at the front; CR CR LF is CR LF written in the wrong mode.
std::size_t line_end_size(std::string_view text) {
  return text.starts_with("\r\r\n") ? 3 : text.starts_with("\r\n") ? 2 : 1;
}

void split_into_lines(std::string_view text, CsvText& csv) {
  std::set<std::string_view> line_ends;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  csv.ends_open = !text.empty() && text.find_last_of("\r\n") != text.size() - 1;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    csv.lines.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
    const std::string_view end = text.substr(0, line_end_size(text));
    if (!end.empty()) line_ends.insert(end);
    text.remove_prefix(end.size());
  }
  if (line_ends.size() > 1) csv.notes.emplace_back("mixed line endings; all are accepted");
  while (!csv.lines.empty() && csv.is_blank(csv.lines.size())) {
    csv.lines.pop_back();
    csv.ends_open = false;
  }
}

}  // namespace

CsvText read_csv(const std::filesystem::path& file, char separator) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": cannot be read");
  std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (stream.bad()) throw InputError(file.string() + ": cannot be read");
  return csv_from_text(file.string(), std::move(text), separator);
}

CsvText csv_from_text(const std::string& file, std::string text, char separator) {
  CsvText csv;
  csv.file = file;
  csv.separator = separator;
  if (const auto order = utf16_order(text)) {
    text = utf8_from_utf16(text, *order);
    csv.notes.emplace_back("the text is UTF-16; converted");
  }
  if (text.find('\0') != std::string::npos)
    throw InputError(csv.file + ": contains null bytes: not a text file, or not UTF-8");
  if (!is_utf8(text)) {
    text = utf8_from_latin1(text);
    csv.notes.emplace_back("the text is not UTF-8; assumed ISO 8859-1");
  }
  split_into_lines(text, csv);
  return csv;
}

bool CsvText::is_blank(std::size_t line) const {
  return lines[line - 1].find_first_not_of(std::string{separator, ' ', '\t'}) == std::string::npos;
}

std::size_t CsvText::filled_line(std::size_t line) const {
  while (line <= lines.size() && is_blank(line)) ++line;
  return line;
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

std::optional<double> CsvText::value(std::string_view cell) const {
  const std::size_t comma = cell.find(',');
  if (decimal_comma && cell.find('.') != std::string_view::npos) return {};
  if (comma == std::string_view::npos) return finite_number(cell);
  if (!decimal_comma) return {};
  std::string with_point(cell);
  with_point[comma] = '.';
  return finite_number(with_point);
}

double CsvText::number(std::size_t line, std::string_view column, std::string_view cell) const {
  const std::optional<double> number = value(cell);
  if (!number) fail(line, column, fmt::format("must be a number, not '{}'", cell));
  return *number;
}

double CsvText::number_or_unknown(std::size_t line, std::string_view column,
                                  std::string_view cell) const {
  if (const std::optional<double> known = value(cell)) return *known;
  return is_missing_value(cell) ? kUnknown : number(line, column, cell);
}

bool is_missing_value(std::string_view cell) {
  static const std::set<std::string> kWords = {
      "nan", "na", "n/a", "<na>", "null", "none", "nil", "missing", "inf", "infinity", "undefined"};
  if (cell.empty() || cell.starts_with('#')) return true;
  if (cell.find_first_not_of(cell[0]) == std::string_view::npos &&
      std::string_view("-.*?").find(cell[0]) != std::string_view::npos) {
    return true;
  }
  std::string word(without_sign(cell));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return kWords.contains(word) || word.starts_with("1.#") || word.starts_with("nan(");
}

std::optional<double> finite_number(std::string_view cell) {
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace morphe::files
