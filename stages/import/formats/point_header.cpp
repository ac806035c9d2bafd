#include "stages/import/formats/point_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kMaxHeaderLine = 30;  // lines
char separator_of(const files::CsvText& text) {
  // The last line is a row: names may contain any character.
  const std::string& row = text.lines.back();
  for (const char sign : {';', '\t'}) {
    if (std::ranges::count(row, sign) >= 2) return sign;
  }
  return ',';
}

/// The numbers of cells, numbers and words in a line.
struct CellCounts {
  std::size_t cells = 0, numbers = 0, words = 0;
};

CellCounts count_cells(const std::vector<std::string>& cells, bool decimal_comma) {
  CellCounts kind{cells.size(), 0, 0};
  for (const std::string& cell : cells) {
    if (parse_number(cell, decimal_comma)) {
      ++kind.numbers;
    } else if (!is_missing_value(cell)) {
      ++kind.words;
    }
  }
  return kind;
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

/// The lines of the header: the last one of words near the top, and those above it with as many
/// cells as a row.
struct HeaderLines {
  std::size_t first = 0, last = 0;  ///< 0 if absent
};

HeaderLines find_header(const files::CsvText& text, const PointHeader& header) {
  HeaderLines lines;
  const std::size_t end = std::min(kMaxHeaderLine, text.lines.size());
  for (std::size_t line = 1; line <= end; ++line) {
    const CellCounts kind =
        count_cells(quoted_cells(text.lines[line - 1], header.separator), header.decimal_comma);
    if (kind.words >= 3 && kind.words >= kind.numbers) lines.last = line;
  }
  lines.first = lines.last;
  while (lines.first > 1) {
    const CellCounts above = count_cells(
        quoted_cells(text.lines[lines.first - 2], header.separator), header.decimal_comma);
    if (above.words + above.numbers == 0 || 2 * above.cells < header.cells) break;
    --lines.first;
  }
  return lines;
}

/// Returns the joined words above a column; a name also applies to up to two empty cells after it.
std::vector<std::string> labels_of(const files::CsvText& text, const HeaderLines& lines,
                                   const PointHeader& header) {
  std::vector<std::string> labels(header.cells);
  for (std::size_t line = lines.first; line <= lines.last; ++line) {
    std::string_view here = text.lines[line - 1];
    if (line == lines.first && here.starts_with('#')) here.remove_prefix(1);
    const std::vector<std::string> cells = quoted_cells(here, header.separator);
    std::string name;
    std::size_t empty = 0;
    for (std::size_t c = 0; c < header.cells; ++c) {
      const std::string cell = c < cells.size() ? cells[c] : "";
      if (!cell.empty()) name = cell;
      empty = cell.empty() ? empty + 1 : 0;
      if (line == lines.last && cell.empty()) continue;
      if (empty > 2 || name.empty()) continue;
      labels[c] += (labels[c].empty() ? "" : " ") + name;
    }
  }
  return labels;
}

struct AxisColumns {
  std::array<std::optional<std::size_t>, 4> at;
};

/// Takes the columns of every point whose three axes have the same notation.
void take_points(const files::CsvText& text, std::size_t line,
                 const std::vector<ColumnLabel>& labels, std::vector<bool>& taken,
                 PointHeader& header) {
  for (std::size_t way = 0; way < 3; ++way) {
    std::map<std::string, AxisColumns> found;
    std::vector<std::string> order;
    for (std::size_t c = 0; c < labels.size(); ++c) {
      if (taken[c] || labels[c].text.empty()) continue;
      const AxisReading reading = readings_of(labels[c].text)[way];
      if (reading.axis < 0 || reading.name.empty()) continue;
      auto [entry, is_new] = found.try_emplace(reading.name);
      if (is_new) order.push_back(reading.name);
      std::optional<std::size_t>& at = entry->second.at[reading.axis];
      if (at) text.fail(line, labels[c].text, "the column appears twice");
      at = c;
    }
    for (const std::string& name : order) {
      const auto& at = found[name].at;
      if (!at[0] || !at[1] || !at[2]) continue;
      for (const auto& column : at) {
        if (column) taken[*column] = true;
      }
      if (at[3] || is_other_quantity(name)) {
        header.ignored_columns.push_back(name);
        continue;
      }
      header.points.push_back({name, {*at[0], *at[1], *at[2]}});
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
  for (std::string& label : labels_of(text, lines, header)) {
    labels.push_back(split_unit(std::move(label)));
  }
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
    for (const std::size_t c : point.at) {
      const std::string& unit = labels[c].unit;
      if (&point == &header.points.front() && c == point.at[0]) header.unit = unit;
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
