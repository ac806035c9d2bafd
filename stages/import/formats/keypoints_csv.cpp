// 21 points of a hand as text: column names, then a row per frame. The columns, in any order, are
// `frame` (increasing whole numbers) or `time_s`, and kp00_x … kp20_z: the wrist, then four per
// finger from its base to its tip, thumb first. An empty cell or "nan" means not seen. The file
// contains neither unit nor rate.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include "core/files/csv.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/named_columns.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kCsvKeypointCount = 21;

/// The positions of the numbers in a row.
struct KeypointColumns {
  std::optional<std::size_t> frame, time_s;
  std::size_t of_point[kCsvKeypointCount][3] = {};
};

std::string column_name(std::size_t point, std::size_t axis) {
  return fmt::format("kp{:02}_{}", point, "xyz"[axis]);
}

KeypointColumns read_columns(const NamedColumns& named) {
  std::set<std::size_t> known;
  const auto take = [&](const std::string& name) { return *known.insert(named.at(name)).first; };
  KeypointColumns columns;
  if (named.has("frame")) columns.frame = take("frame");
  if (named.has("time_s")) columns.time_s = take("time_s");
  if (known.empty())
    named.csv.fail(named.line, "frame", "column not found; frame or time_s is required");
  for (std::size_t point = 0; point < kCsvKeypointCount; ++point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns.of_point[point][axis] = take(column_name(point, axis));
    }
  }
  for (std::size_t c = 0; c < named.names.size(); ++c) {
    if (!known.contains(c)) named.csv.fail(named.line, named.names[c], "unknown column");
  }
  return columns;
}

Vec3 read_point(const files::CsvText& csv, std::size_t line,
                const std::vector<std::string_view>& cells, const KeypointColumns& columns,
                std::size_t point) {
  Vec3 result = unknown_point();
  int filled = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view cell = cells[columns.of_point[point][axis]];
    if (cell.empty() || cell == "nan" || cell == "NaN") continue;
    result[axis] = csv.number(line, column_name(point, axis), cell);
    ++filled;
  }
  if (filled != 0 && filled != 3) {
    csv.fail(line, column_name(point, 0), "has only some of x, y, z");
  }
  return result;
}

double read_time(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const KeypointColumns& columns,
                 double rate_hz) {
  if (columns.time_s) return csv.number(line, "time_s", cells[*columns.time_s]);
  const double frame = csv.number(line, "frame", cells[*columns.frame]);
  if (frame != std::floor(frame) || frame < 0) {
    csv.fail(line, "frame", "must be a whole number, at least 0");
  }
  return frame / rate_hz;
}

/// Reports unseen points, and rejects a hand with an implausible size.
void check_keypoints(const files::CsvText& csv, const HandStream& hand, bool judged,
                     std::vector<std::string>& reports) {
  std::size_t unseen = 0, centred = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < hand.position.rows; ++i) {
    const Vec3& wrist = hand.position(i, 0);
    if (is_known(wrist) && wrist.norm() < 1e-6) ++centred;
    for (std::size_t point = 0; point < kCsvKeypointCount; ++point) {
      const Vec3& here = hand.position(i, point);
      if (!is_known(here)) ++unseen;
      if (is_known(here) && is_known(wrist)) farthest = std::max(farthest, (here - wrist).norm());
    }
  }
  if (unseen == hand.position.values.size()) {
    reports.push_back("no point is visible in any frame");
  } else if (unseen > 0) {
    reports.push_back(
        fmt::format("{} of {} points are not visible", unseen, hand.position.values.size()));
  }
  if (judged && farthest > 0 && (farthest < 0.05 || farthest > 0.5)) {
    throw UnresolvedConvention(
        "unit", fmt::format("{}:1: unit: implausible: a point would be {:.3g} m from the wrist",
                            csv.file, farthest));
  }
  reports.push_back(
      centred == hand.position.rows
          ? "the wrist is the origin in every frame: the points are in the frame of the hand and "
            "do not show where the hand was"
          : "the points stay in the axes of the file; only the shape of the hand is used");
}

}  // namespace

bool recognises_keypoints_csv(std::string_view head) {
  const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
  return line.find("kp00_x") != std::string_view::npos &&
         line.find("kp20_z") != std::string_view::npos;
}

Demonstration read_keypoints_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_csv(files.file);
  if (!files.static_trial.empty()) csv.fail(1, "static_trial", "this format has no static trial");
  if (!files.name_map.empty())
    csv.fail(1, "names", "this format has no names to map; remove names");
  if (!files.conventions.axes.empty()) {
    csv.fail(1, "axes", "are not used: only the shape of the hand is used; remove axes");
  }
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns named(csv, 1);
  const KeypointColumns columns = read_columns(named);
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = csv.notes;
  const double metres = resolve_unit_m("", files.conventions, csv.file, reports);
  const double rate_hz =
      columns.time_s ? 0 : resolve_rate_hz(0, files.conventions, csv.file, reports);

  HandStream hand;
  hand.kind = HandKind::keypoints;
  hand.position = Array2D<Vec3>(named.rows(), kCsvKeypointCount, unknown_point());
  for (std::size_t line = named.first_row(); line <= csv.lines.size(); ++line) {
    const auto cells = named.cells(line);
    hand.time.push_back(read_time(csv, line, cells, columns, rate_hz));
    if (hand.time.size() > 1 && !(hand.time.back() > hand.time[hand.time.size() - 2])) {
      csv.fail(line, columns.time_s ? "time_s" : "frame",
               "must be greater than in the previous row");
    }
    for (std::size_t point = 0; point < kCsvKeypointCount; ++point) {
      hand.position(line - named.first_row(), point) =
          metres * read_point(csv, line, cells, columns, point);
    }
  }
  check_keypoints(csv, hand, files.conventions.plausibility_checks, reports);
  demonstration.streams.hand = std::move(hand);
  return demonstration;
}

}  // namespace morphe::imports
