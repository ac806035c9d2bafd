#include "core/files/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace morphe::files {
namespace {

constexpr std::size_t kTestedRows = 6;     ///< last lines that show separator and decimal comma
constexpr std::size_t kDecimalsRows = 10;  ///< last rows that show the usual number of decimals
constexpr std::ptrdiff_t kMinSeparators = 2;
constexpr std::ptrdiff_t kBlankRows = 2;   ///< last lines that must be rows separated by blanks
constexpr std::size_t kMinBlankCells = 4;  ///< of rows separated by blanks: a time and a point

/// Returns the last lines that have text, at most `count`.
std::vector<std::size_t> last_lines(const CsvText& csv, std::size_t count) {
  std::vector<std::size_t> lines;
  for (std::size_t line = csv.lines.size(); line > 0 && lines.size() < count; --line) {
    if (!csv.is_blank(line)) lines.push_back(line);
  }
  return lines;
}

/// Replaces runs of blanks by tabs.
std::string with_tabs(std::string_view line) {
  std::string result;
  bool pending = false;
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t';
    if (!blank && pending && !result.empty()) result += '\t';
    if (!blank) result += c;
    pending = blank;
  }
  return result;
}

/// Returns true if the line consists of numbers and missing values between blanks.
bool is_row_of_blanks(const CsvText& csv, const std::string& line) {
  CsvText row;
  row.lines = {with_tabs(line)};
  row.separator = '\t';
  const auto cells = row.cells(1);
  return cells.size() >= kMinBlankCells && std::ranges::all_of(cells, [&](std::string_view cell) {
           return csv.value(cell) || is_missing_value(cell);
         });
}

void find_separator(CsvText& csv) {
  const std::vector<std::size_t> rows = last_lines(csv, kTestedRows);
  const auto most = [&](const auto& has) {
    return 2 * std::ranges::count_if(rows, has) > std::ssize(rows);
  };
  for (const char separator : {';', '\t', ','}) {
    csv.separator = separator;
    const bool found = most([&](std::size_t line) {
      return std::ranges::count(csv.lines[line - 1], separator) >= kMinSeparators;
    });
    if (found) return;
  }
  const bool blanks =
      std::all_of(rows.begin(), rows.begin() + std::min(kBlankRows, std::ssize(rows)),
                  [&](std::size_t line) { return is_row_of_blanks(csv, csv.lines[line - 1]); });
  if (rows.empty() || !blanks) return;
  csv.separator = '\t';
  for (std::string& line : csv.lines) line = with_tabs(line);
}

void find_decimal_comma(CsvText& csv) {
  if (csv.separator == ',') return;
  CsvText with_comma;
  with_comma.decimal_comma = true;
  for (const std::size_t line : last_lines(csv, kTestedRows)) {
    for (const std::string_view cell : csv.cells(line)) {
      if (cell.find(',') != std::string_view::npos && with_comma.value(cell))
        csv.decimal_comma = true;
    }
  }
  if (csv.decimal_comma) csv.notes.emplace_back("numbers use decimal commas");
}

/// Removes quotes; a separator between them becomes a blank, and two quotes between them one.
std::string without_quotes(std::string_view line, char separator) {
  std::string result;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c != '"') {
      result += quoted && c == separator ? ' ' : c;
    } else if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
      result += line[++i];
    } else {
      quoted = !quoted;
    }
  }
  return result;
}

std::size_t decimals_of(std::string_view cell, char point) {
  const std::size_t at = cell.find(point);
  return at == std::string_view::npos ? 0 : cell.size() - at - 1;
}

/// Returns the decimals that the last cells of all rows above the last line have, if equally many.
std::optional<std::size_t> usual_decimals(const CsvText& csv) {
  const char point = csv.decimal_comma ? ',' : '.';
  std::optional<std::size_t> usual;
  std::size_t rows = 0;
  for (const std::size_t line : last_lines(csv, kDecimalsRows)) {
    if (line == csv.lines.size()) continue;
    const std::string_view cell = csv.cells(line).back();
    if (!csv.value(cell)) continue;
    const std::size_t decimals = decimals_of(cell, point);
    if (usual && *usual != decimals) return std::nullopt;
    usual = decimals;
    ++rows;
  }
  return rows + 2 < kDecimalsRows ? std::nullopt : usual;
}

void drop_cut_line(CsvText& csv) {
  const std::size_t last = csv.lines.size();
  if (!csv.ends_open || last < 3) return;
  const auto cells = csv.cells(last), above = csv.cells(last - 1);
  if (!csv.value(above[0])) return;  // a header
  const bool cut_between = cells.size() < above.size();
  const std::optional<std::size_t> decimals = usual_decimals(csv);
  const bool cut_within = cells.size() == above.size() && decimals && csv.value(cells.back()) &&
                          decimals_of(cells.back(), csv.decimal_comma ? ',' : '.') < *decimals;
  if (!cut_between && !cut_within) return;
  csv.notes.push_back(fmt::format("the last line is cut off in its cell {} of {}; skipped",
                                  cells.size(), above.size()));
  csv.lines.pop_back();
  csv.ends_open = false;
}

CsvText as_table(CsvText csv) {
  if (csv.lines.empty()) return csv;
  find_separator(csv);
  for (std::string& line : csv.lines) {
    if (line.find('"') != std::string::npos) line = without_quotes(line, csv.separator);
  }
  find_decimal_comma(csv);
  return csv;
}

}  // namespace

CsvText read_table(const std::filesystem::path& file) {
  CsvText csv = as_table(read_csv(file));
  drop_cut_line(csv);
  return csv;
}

CsvText table_from_text(const std::string& file, std::string text) {
  return as_table(csv_from_text(file, std::move(text)));
}

std::string first_line_with_commas(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" ;,\t\r\n"), text.size());
  const std::string_view line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  std::string result = without_quotes(line, ',');
  std::ranges::replace_if(
      result, [](char c) { return c == ';' || c == '\t'; }, ',');
  return result;
}

}  // namespace morphe::files
