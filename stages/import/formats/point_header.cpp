#include "stages/import/formats/point_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kMaxHeaderLine = 30;

char separator_of(const files::CsvText& text) {
  // Counted in the last line, which is a row: names in the header may contain any character.
  const std::string& row = text.lines.back();
  for (const char separator : {';', '\t'}) {
    if (std::ranges::count(row, separator) >= 2) return separator;
  }
  return ',';
}

struct CellCounts {
  std::size_t cells = 0, numbers = 0, words = 0;
};

CellCounts count_cells(const std::string& line, const PointHeader& header) {
  const std::vector<std::string> cells = quoted_cells(line, header.separator);
  CellCounts counts{cells.size(), 0, 0};
  for (const std::string& cell : cells) {
    if (parse_number(cell, header.decimal_comma)) {
      ++counts.numbers;
    } else if (!is_missing_value(cell)) {
      ++counts.words;
    }
  }
  return counts;
}

bool has_decimal_commas(const files::CsvText& text, char separator) {
  if (separator == ',') return false;
  for (std::size_t line = text.lines.size(); line > 0 && line + 5 > text.lines.size(); --line) {
    for (const std::string& cell : quoted_cells(text.lines[line - 1], separator)) {
      if (cell.find(',') != std::string::npos && parse_number(cell, true)) return true;
    }
  }
  return false;
}

/// The lines of the header, from 1: the last line of words near the top, and the lines directly
/// above it that are not blank and have at least half as many cells as a row.
struct HeaderLines {
  std::size_t first = 0, last = 0;  ///< 0 if absent
};

HeaderLines find_header(const files::CsvText& text, const PointHeader& header) {
  HeaderLines lines;
  const std::size_t end = std::min(kMaxHeaderLine, text.lines.size());
  for (std::size_t line = 1; line <= end; ++line) {
    const CellCounts counts = count_cells(text.lines[line - 1], header);
    if (counts.words >= 3 && counts.words >= counts.numbers) lines.last = line;
  }
  lines.first = lines.last;
  while (lines.first > 1) {
    const CellCounts above = count_cells(text.lines[lines.first - 2], header);
    if (above.words + above.numbers == 0 || 2 * above.cells < header.cells) break;
    --lines.first;
  }
  return lines;
}

/// Returns the joined words above each column; a name also applies to two empty cells after it.
std::vector<std::string> labels_of(const files::CsvText& text, const HeaderLines& lines,
                                   const PointHeader& header) {
  std::vector<std::string> labels(header.cells);
  for (std::size_t line = lines.first; line <= lines.last; ++line) {
    std::string_view words = text.lines[line - 1];
    if (line == lines.first && words.starts_with('#')) words.remove_prefix(1);
    const std::vector<std::string> cells = quoted_cells(words, header.separator);
    std::string name;
    int empty_count = 0;
    for (std::size_t c = 0; c < header.cells; ++c) {
      const std::string cell = c < cells.size() ? cells[c] : "";
      if (!cell.empty()) name = cell;
      empty_count = cell.empty() ? empty_count + 1 : 0;
      if (line == lines.last && cell.empty()) continue;
      if (empty_count > 2 || name.empty()) continue;
      labels[c] += (labels[c].empty() ? "" : " ") + name;
    }
  }
  return labels;
}

/// Adds every point whose three axes have the same notation, and marks its columns as taken.
void take_points(const files::CsvText& text, std::size_t line,
                 const std::vector<ColumnLabel>& labels, std::vector<bool>& taken,
                 PointHeader& header) {
  using AxisColumns = std::array<std::optional<std::size_t>, 4>;  // of x, y, z, w
  for (int notation = 0; notation < 3; ++notation) {
    std::map<std::string, AxisColumns> points;
    std::vector<std::string> order;
    for (std::size_t c = 0; c < labels.size(); ++c) {
      if (taken[c] || labels[c].text.empty()) continue;
      const AxisReading reading = readings_of(labels[c].text)[notation];
      if (reading.axis < 0 || reading.name.empty()) continue;
      auto [entry, is_new] = points.try_emplace(reading.name);
      if (is_new) order.push_back(reading.name);
      std::optional<std::size_t>& column = entry->second[reading.axis];
      if (column) text.fail(line, labels[c].text, "the column appears twice");
      column = c;
    }
    for (const std::string& name : order) {
      const AxisColumns& columns = points[name];
      const auto& [x, y, z, w] = columns;
      if (!x || !y || !z) continue;
      for (const auto& column : columns) {
        if (column) taken[*column] = true;
      }
      if (w || is_other_quantity(name)) {
        header.ignored_columns.push_back(name);
      } else {
        header.points.push_back({name, {*x, *y, *z}});
      }
    }
  }
}

}  // namespace

std::vector<std::string> quoted_cells(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = trim(cell, " \t");
  return cells;
}

std::optional<double> parse_number(std::string_view cell, bool decimal_comma) {
  const std::size_t comma = cell.find(',');
  if (decimal_comma && cell.find('.') != std::string_view::npos) return {};
  if (comma == std::string_view::npos) return files::finite_number(cell);
  if (!decimal_comma) return {};
  std::string with_point(cell);
  with_point[comma] = '.';
  return files::finite_number(with_point);
}

bool is_missing_value(std::string_view cell) {
  static const std::set<std::string> kWords = {"", "nan", "na", "n/a", "null", "none", "-"};
  return kWords.contains(to_lower(cell));
}

PointHeader read_point_header(const files::CsvText& text) {
  PointHeader header;
  if (text.lines.empty()) return header;
  header.separator = separator_of(text);
  header.decimal_comma = has_decimal_commas(text, header.separator);
  header.cells = quoted_cells(text.lines.back(), header.separator).size();
  const HeaderLines lines = find_header(text, header);
  if (lines.last == 0) return header;
  header.first_row = lines.last + 1;
  header.lines_before = lines.first - 1;
  std::vector<ColumnLabel> labels;
  for (std::string& label : labels_of(text, lines, header))
    labels.push_back(split_unit(std::move(label)));
  std::vector<bool> taken(labels.size(), false);
  for (std::size_t c = 0; c < labels.size(); ++c) {
    if (!header.time && is_time_label(labels[c].text)) {
      header.time = TimeColumn{c, labels[c].text, labels[c].unit};
      if (to_lower(labels[c].text).starts_with("sec")) header.time->unit = "s";
      taken[c] = true;
    } else if (!header.frame && is_frame_label(labels[c].text)) {
      header.frame = c;
      taken[c] = true;
    }
  }
  take_points(text, lines.last, labels, taken, header);
  for (const PointColumns& point : header.points) {
    for (const std::size_t c : point.columns) {
      const std::string& unit = labels[c].unit;
      if (&point == &header.points.front() && c == point.columns[0]) header.unit = unit;
      if (unit != header.unit) {
        text.fail(
            lines.last, point.name,
            fmt::format("has the unit '{}', but the first point has '{}'", unit, header.unit));
      }
    }
  }
  for (std::size_t c = 0; c < labels.size(); ++c) {
    if (!taken[c] && !labels[c].text.empty()) header.ignored_columns.push_back(labels[c].text);
  }
  return header;
}

}  // namespace morphe::imports
