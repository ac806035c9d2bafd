// 21 points of a hand as text: column names, then a row per frame. The columns, in any order, are
// `frame` (increasing whole numbers) or `time_s`, and kp00_x … kp20_z: the wrist, then four per
// finger from base to tip, thumb first. No unit, no rate.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include "core/files/table_text.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/named_columns.hpp"
#include "stages/import/recording/unseen_points.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/unseen_hands.hpp"

namespace morphe::imports {
namespace {

struct KeypointColumns {
  std::optional<std::size_t> frame, time_s;
  std::size_t point[kKeypointCount][3] = {};
};

std::string column_name(int point, int axis) {
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
  for (int point = 0; point < kKeypointCount; ++point) {
    for (int axis = 0; axis < 3; ++axis)
      columns.point[point][axis] = take(column_name(point, axis));
  }
  for (std::size_t c = 0; c < named.names.size(); ++c) {
    if (!known.contains(c)) named.csv.fail(named.line, named.names[c], "unknown column");
  }
  return columns;
}

Vec3 read_point(const files::CsvText& csv, std::size_t line,
                const std::vector<std::string_view>& cells, const KeypointColumns& columns,
                int point) {
  Vec3 result = unknown_point();
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view cell = cells[columns.point[point][axis]];
    result[axis] = csv.number_or_unknown(line, column_name(point, axis), cell);
  }
  return result;
}

double read_time(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const KeypointColumns& columns,
                 double rate_hz) {
  if (columns.time_s) return csv.number(line, "time_s", cells[*columns.time_s]);
  const double frame = csv.number(line, "frame", cells[*columns.frame]);
  if (frame != std::floor(frame) || frame < 0)
    csv.fail(line, "frame", "must be a whole number, at least 0");
  return frame / rate_hz;
}

/// Reports unseen points; throws UnresolvedConvention for an implausible size, if it is checked.
void check_keypoints(const files::CsvText& csv, const HandStream& hand, bool size_is_checked,
                     std::vector<std::string>& reports) {
  std::size_t unseen = 0, wrists_at_origin = 0;
  double farthest_m = 0;
  for (std::size_t i = 0; i < hand.position.rows; ++i) {
    const Vec3& wrist = hand.position(i, 0);
    if (is_known(wrist) && wrist.norm() < 1e-6) ++wrists_at_origin;
    for (int k = 0; k < kKeypointCount; ++k) {
      const Vec3& point = hand.position(i, k);
      if (!is_known(point)) ++unseen;
      if (is_known(point) && is_known(wrist))
        farthest_m = std::max(farthest_m, (point - wrist).norm());
    }
  }
  if (unseen == hand.position.values.size()) {
    reports.push_back("no point is visible in any frame");
  } else if (unseen > 0) {
    add_note(reports, "{} of {} points are not visible", unseen, hand.position.values.size());
  }
  if (size_is_checked && farthest_m > 0 && (farthest_m < 0.05 || farthest_m > 0.5)) {
    throw UnresolvedConvention(
        "unit", fmt::format("{}:1: unit: implausible: a point would be {:.3g} m from the wrist",
                            csv.file, farthest_m));
  }
  reports.push_back(
      wrists_at_origin == hand.position.rows
          ? "the wrist is the origin in every frame: the points are in the frame of the hand and "
            "do not show where the hand was"
          : "the points stay in the axes of the file; only the shape of the hand is used");
}

}  // namespace

bool recognises_keypoints_csv(std::string_view head) {
  const std::string line = files::first_line_with_commas(head);
  return line.find("kp00_x") != std::string::npos && line.find("kp20_z") != std::string::npos;
}

Demonstration read_keypoints_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_table(files.file);
  if (!files.static_trial.empty()) csv.fail(1, "static_trial", "this format has no static trial");
  if (!files.name_map.empty())
    csv.fail(1, "names", "this format has no names to map; remove names");
  if (!files.conventions.axes.empty())
    csv.fail(1, "axes", "are not used: only the shape of the hand is used; remove axes");
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns named(csv, csv.filled_line(1));
  const KeypointColumns columns = read_columns(named);
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = csv.notes;
  const double metres = resolve_unit_m("", files.conventions, csv.file, reports);
  const double rate_hz =
      columns.time_s ? 0 : resolve_rate_hz(0, files.conventions, csv.file, reports);

  HandStream hand;
  hand.kind = HandKind::keypoints;
  hand.position = Array2D<Vec3>(named.rows(), kKeypointCount, unknown_point());
  for (std::size_t line = named.first_row(); line <= csv.lines.size(); ++line) {
    const auto cells = named.cells(line);
    add_time(read_time(csv, line, cells, columns, rate_hz), csv.file, line,
             columns.time_s ? "time_s" : "frame", hand.time);
    for (int point = 0; point < kKeypointCount; ++point) {
      hand.position(line - named.first_row(), point) =
          metres * read_point(csv, line, cells, columns, point);
    }
  }
  hide_unseen_points("hand", hand.position, reports);
  hide_fillers(metres, hand.position, reports);
  check_keypoints(csv, hand, files.conventions.plausibility_checks, reports);
  demonstration.streams.hand = std::move(hand);
  return demonstration;
}

}  // namespace morphe::imports
