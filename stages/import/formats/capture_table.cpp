#include "stages/import/formats/capture_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/motion/geometry.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;

bool is_missing_cell(std::string_view cell) {
  return cell.empty() || cell == "NaN" || cell == "nan" || cell == "NAN";
}

}  // namespace

CaptureTable read_capture_table(const files::CsvText& csv, const Columns& columns, double rate_hz) {
  if (csv.lines.size() < 2) csv.fail(1, "", "ends before the first row");
  std::vector<bool> needed(columns.names.size(), true);
  for (std::size_t c = 0; c < needed.size(); ++c) {
    needed[c] = std::ranges::find(columns.left_out, columns.names[c]) == columns.left_out.end();
  }
  const std::size_t clock = columns.time != Columns::kNoColumn ? columns.time : columns.frame;
  const double step = columns.time != Columns::kNoColumn ? 1 : 1 / rate_hz;
  CaptureTable rows;
  rows.columns = columns.names.size();
  rows.values.reserve((csv.lines.size() - 1) * rows.columns);
  double first = 0;
  for (std::size_t line = 2; line <= csv.lines.size(); ++line) {
    const auto cells = csv.cells(line);
    if (cells.size() != rows.columns) {
      csv.fail(line, "",
               fmt::format("the row has {} cells, the header has {}", cells.size(), rows.columns));
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      rows.values.push_back(!needed[c] || is_missing_cell(cells[c])
                                ? kUnknown
                                : csv.number(line, columns.names[c], cells[c]));
    }
    const double now = rows[rows.time.size()][clock];
    if (!std::isfinite(now)) csv.fail(line, columns.names[clock], "is empty");
    if (line == 2 && columns.time == Columns::kNoColumn) first = now;
    const double t = (now - first) * step;
    constexpr double kHour = 3600;
    if (!rows.time.empty() && !(t > rows.time.back())) {
      csv.fail(line, columns.names[clock], "must be greater than in the previous row");
    }
    if (!rows.time.empty() && t - rows.time.back() > kHour) {
      csv.fail(line, columns.names[clock], "increases by more than one hour");
    }
    rows.time.push_back(t);
  }
  return rows;
}

}  // namespace morphe::imports
