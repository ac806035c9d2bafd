#include "stages/import/formats/marker_columns.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace morphe::imports {

std::string MarkerColumns::name(std::size_t column) const {
  if (column < kLeadingCount) return leading[column];
  return fmt::format("{}.{}", names[(column - kLeadingCount) / 3],
                     "XYZ"[(column - kLeadingCount) % 3]);
}

std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line) {
  const auto cells = csv.cells(line);
  std::size_t end = cells.size();
  while (end > MarkerColumns::kLeadingCount && cells[end - 1].empty()) --end;
  std::vector<std::string> names;
  std::set<std::string_view> known;
  for (std::size_t c = MarkerColumns::kLeadingCount; c < end; ++c) {
    const bool begins_marker = (c - MarkerColumns::kLeadingCount) % 3 == 0;
    if (begins_marker == cells[c].empty()) {
      csv.fail(line, fmt::format("column {}", c + 1),
               begins_marker
                   ? "has no marker name"
                   : fmt::format("unexpected '{}': no marker begins in this column", cells[c]));
    }
    if (!begins_marker) continue;
    if (!known.insert(cells[c]).second) csv.fail(line, cells[c], "the marker appears twice");
    names.emplace_back(cells[c]);
  }
  if (names.empty()) csv.fail(line, "", "has no marker names");
  return names;
}

void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Array2D<Vec3>& position, std::size_t row) {
  const auto wrong_count = [&](const std::string& key) {
    csv.fail(line, key,
             fmt::format("the row has {} cells, the header has {}", cells.size(), columns.count()));
  };
  if (cells.size() < columns.count()) wrong_count(columns.name(cells.size()));
  for (std::size_t c = columns.count(); c < cells.size(); ++c) {
    if (!cells[c].empty()) wrong_count(fmt::format("column {}", c + 1));
  }
  for (std::size_t k = 0; k < columns.names.size(); ++k) {
    Vec3 point = unknown_point();
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t c = MarkerColumns::kLeadingCount + 3 * k + axis;
      const std::string_view cell = cells[c];
      if (cell.empty() || cell == "NaN" || cell == "nan" || cell == "NAN") continue;
      const std::optional<double> value = files::finite_number(cell);
      if (!value) csv.number(line, columns.name(c), cell);  // fails with the location
      point[axis] = *value * metres;
    }
    if (is_partial(point)) csv.fail(line, columns.names[k], "has only some of X, Y, Z");
    position(row, k) = point;
  }
}

}  // namespace morphe::imports
