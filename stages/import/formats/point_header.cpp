#include "stages/import/formats/point_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "core/files/csv.hpp"
#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kMaxHeaderLine = 30;

struct CellCounts {
  std::size_t cells = 0, numbers = 0, words = 0;
};

CellCounts count_cells(const files::CsvText& text, std::size_t line) {
  const auto cells = text.cells(line);
  CellCounts counts{cells.size(), 0, 0};
  for (const std::string_view cell : cells) {
    if (text.value(cell)) {
      ++counts.numbers;
    } else if (!files::is_missing_value(cell)) {
      ++counts.words;
    }
  }
  return counts;
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
    const CellCounts counts = count_cells(text, line);
    if (counts.words >= 3 && counts.words >= counts.numbers) lines.last = line;
  }
  lines.first = lines.last;
  while (lines.first > 1) {
    const CellCounts above = count_cells(text, lines.first - 1);
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
    const auto cells = text.cells(line);
    std::string name;
    int empty_count = 0;
    for (std::size_t c = 0; c < header.cells; ++c) {
      std::string cell(c < cells.size() ? cells[c] : std::string_view());
      if (line == lines.first && c == 0 && cell.starts_with('#')) cell = trim(cell, "# \t");
      if (!cell.empty()) name = cell;
      empty_count = cell.empty() ? empty_count + 1 : 0;
      if (line == lines.last && cell.empty()) continue;
      if (empty_count > 2 || name.empty()) continue;
      labels[c] += (labels[c].empty() ? "" : " ") + name;
    }
  }
  return labels;
}

/// Numbers the names of points in labels that stand more than once: a second "cup x" is "cup_2 x".
void number_repeated_labels(std::vector<ColumnLabel>& labels, std::vector<std::string>& notes) {
  std::map<std::string, int> counts;
  std::set<std::string> repeated;
  for (ColumnLabel& label : labels) {
    const int count = label.text.empty() ? 1 : ++counts[to_lower(label.text)];
    if (count == 1) continue;
    const auto readings = readings_of(label.text);
    const auto reading = std::ranges::find_if(
        readings, [](const AxisReading& r) { return r.axis >= 0 && !r.name.empty(); });
    if (reading == readings.end()) continue;
    const std::string name = fmt::format("{}_{}", reading->name, count);
    if (repeated.insert(name).second) {
      notes.push_back(fmt::format("the name {} stands more than once; another is called {}",
                                  reading->name, name));
    }
    label.text = fmt::format("{} {}", name, "xyzw"[reading->axis]);
  }
}

/// Adds every point whose three axes have the same notation, and marks its columns as taken.
void take_points(const std::vector<ColumnLabel>& labels, std::vector<bool>& taken,
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
      if (!column) column = c;
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

PointHeader read_point_header(const files::CsvText& text) {
  PointHeader header;
  if (text.lines.empty()) return header;
  header.cells = text.cells(text.lines.size()).size();
  const HeaderLines lines = find_header(text, header);
  if (lines.last == 0) return header;
  header.first_row = lines.last + 1;
  header.lines_before = lines.first - 1;
  std::vector<ColumnLabel> labels;
  for (std::string& label : labels_of(text, lines, header))
    labels.push_back(split_unit(std::move(label)));
  number_repeated_labels(labels, header.notes);
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
  take_points(labels, taken, header);
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
