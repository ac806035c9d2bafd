#include "stages/import/formats/capture_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/geometry.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {

CaptureTable read_capture_table(const files::CsvText& csv, const CaptureColumns& columns,
                                double rate_hz) {
  if (csv.lines.size() < 2) csv.fail(1, "", "ends before the first row");
  std::vector<bool> needed(columns.names.size(), true);
  for (std::size_t c = 0; c < needed.size(); ++c)
    needed[c] = std::ranges::find(columns.left_out, columns.names[c]) == columns.left_out.end();
  const bool has_time = columns.time != CaptureColumns::kNoColumn;
  const int clock = has_time ? columns.time : columns.frame;
  const double unit_s = has_time ? 1 : 1 / rate_hz;
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
      rows.values.push_back(needed[c] ? csv.number_or_unknown(line, columns.names[c], cells[c])
                                      : kUnknown);
    }
    const double now = rows[rows.time.size()][clock];
    if (!std::isfinite(now)) csv.fail(line, columns.names[clock], "is empty");
    if (line == 2 && !has_time) first = now;
    constexpr double kHour_s = 3600;
    add_time((now - first) * unit_s, csv.file, line, columns.names[clock], rows.time);
    const std::size_t count = rows.time.size();
    if (count > 1 && rows.time[count - 1] - rows.time[count - 2] > kHour_s)
      csv.fail(line, columns.names[clock], "increases by more than one hour");
  }
  return rows;
}

}  // namespace morphe::imports
