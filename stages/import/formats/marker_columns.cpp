#include "stages/import/formats/marker_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "stages/import/recording/repeated_names.hpp"

namespace morphe::imports {

std::string MarkerColumns::name(std::size_t column) const {
  if (column < leading.size()) return leading[column];
  const std::size_t k = column - leading.size();
  return fmt::format("{}.{}", names[k / 3], "XYZ"[k % 3]);
}

std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line,
                                           std::size_t leading, std::vector<std::string>& notes) {
  const auto cells = csv.cells(line);
  std::size_t end = cells.size();
  while (end > leading && cells[end - 1].empty()) --end;
  std::vector<std::string> names;
  for (std::size_t c = leading; c < end; ++c) {
    const bool begins_marker = (c - leading) % 3 == 0;
    if (!begins_marker && cells[c] == names.back()) continue;  // above Y and Z again
    if (begins_marker == cells[c].empty()) {
      csv.fail(line, fmt::format("column {}", c + 1),
               begins_marker
                   ? "has no marker name"
                   : fmt::format("unexpected '{}': no marker begins in this column", cells[c]));
    }
    if (!begins_marker) continue;
    names.emplace_back(cells[c]);
  }
  if (names.empty()) csv.fail(line, "", "has no marker names");
  number_repeated_names(names, notes);
  return names;
}

void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Array2D<Vec3>& position, std::size_t row) {
  const auto wrong_count = [&](const std::string& key) {
    csv.fail(line, key,
             fmt::format("the row has {} cells, the header has {}", cells.size(), columns.count()));
  };
  const std::size_t leading = columns.leading.size();
  const bool trimmed = csv.separator == '\t' && cells.size() >= leading && !cells.back().empty() &&
                       (columns.count() - std::min(cells.size(), columns.count())) % 3 == 0;
  if (cells.size() < columns.count() && !trimmed) wrong_count(columns.name(cells.size()));
  for (std::size_t c = columns.count(); c < cells.size(); ++c) {
    if (!cells[c].empty()) wrong_count(fmt::format("column {}", c + 1));
  }
  for (std::size_t k = 0; k < columns.names.size(); ++k) {
    Vec3 point = unknown_point();
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t c = leading + 3 * k + axis;
      if (c >= cells.size()) continue;
      const std::optional<double> value = csv.value(cells[c]);
      point[axis] =
          metres * (value ? *value : csv.number_or_unknown(line, columns.name(c), cells[c]));
    }
    position(row, k) = point;
  }
}

}  // namespace morphe::imports
