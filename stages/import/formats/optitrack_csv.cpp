// Takes that OptiTrack's Motive exports as CSV: rigid bodies and markers. Line 1 contains pairs of
// a key and its value (format version, rates, units); then follow the types, names and IDs of the
// columns, their quantities, "Frame,Time…" above X, Y, Z and W, and a row per frame. A body or
// marker that was not seen has empty cells. Quaternions are x, y, z, w.
//
// A marker may occur twice: as computed from the body's pose ("Rigid Body Marker") and as measured
// ("Marker"). The measured one is used if it exists.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/files/table_text.hpp"
#include "core/motion/count_with_noun.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/optitrack_header.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/formats/rigid_bodies.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

using Items = std::vector<const OptitrackItem*>;

struct TakeRow {
  const files::CsvText& csv;
  std::size_t line;
  std::vector<std::string_view> cells;

  /// Returns the numbers of an item, NaN for those that are missing; empty if all are.
  std::vector<double> numbers(const OptitrackItem& item, const char* quantity,
                              const std::vector<std::size_t>& columns) const {
    const std::string key = fmt::format("{}.{}", item.name, quantity);
    std::vector<double> values;
    for (const std::size_t c : columns)
      values.push_back(csv.number_or_unknown(line, key, cells[c]));
    const bool seen = std::ranges::any_of(values, [](double v) { return !std::isnan(v); });
    return seen ? values : std::vector<double>{};
  }
};

struct Take {
  Items bodies, measured, solved;
  int unlabelled = 0;
  std::set<std::string> other_types;  ///< types of the items that are left out
};

Take sort_items(const OptitrackHeader& header) {
  Take take;
  for (const OptitrackItem& item : header.items) {
    const std::string type = item.position.empty() ? "" : item.type;
    if (item.name.starts_with("Unlabeled") || item.name.starts_with("Unlabelled")) {
      ++take.unlabelled;
    } else if ((type == "Rigid Body" || type == "Bone") && !item.rotation.empty()) {
      take.bodies.push_back(&item);
    } else if (type == "Marker") {
      take.measured.push_back(&item);
    } else if (type == "Rigid Body Marker" || type == "Bone Marker") {
      take.solved.push_back(&item);
    } else {
      take.other_types.insert(item.type);
    }
  }
  return take;
}

/// Returns the measured markers, and those computed ("solved") that were not measured.
Items markers_of(const Take& take) {
  Items markers = take.measured;
  const auto is_measured = [&](const OptitrackItem* solved) {
    return std::ranges::find(take.measured, solved->name, &OptitrackItem::name) !=
           take.measured.end();
  };
  std::ranges::remove_copy_if(take.solved, std::back_inserter(markers), is_measured);
  return markers;
}

/// Returns the rotation of a quaternion x, y, z, w, or of three angles about X, Y and Z [degrees],
/// by which the body turns about its own axes one after another, in `order`, such as "XYZ".
Quat rotation_from_numbers(const std::vector<double>& numbers, const std::string& order) {
  if (numbers.size() == 4) return Quat(numbers[3], numbers[0], numbers[1], numbers[2]);
  Quat rotation = Quat::Identity();
  for (const char axis : order) {
    const int k = axis - 'X';
    rotation = rotation * Eigen::AngleAxisd(numbers[k] * kRadPerDegree, Vec3::Unit(k));
  }
  return rotation;
}

void check_rotation_order(const files::CsvText& csv, const std::string& order,
                          const Items& bodies) {
  if (std::ranges::none_of(bodies, [](const auto* b) { return b->rotation.size() == 3; })) return;
  std::string axes = order;
  std::ranges::sort(axes);
  if (axes != "XYZ") {
    csv.fail(1, "Rotation Type",
             fmt::format("must be Quaternion or an order such as XYZ, not '{}'", order));
  }
}

bool has_nan(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return std::isnan(v); });
}

void read_body(const TakeRow& row, const OptitrackItem& item, const std::string& order,
               double metres, BodyStream& bodies, std::size_t i, std::size_t k) {
  const std::vector<double> position = row.numbers(item, "Position", item.position);
  const std::vector<double> rotation = row.numbers(item, "Rotation", item.rotation);
  if (position.empty() || rotation.empty() || has_nan(position) || has_nan(rotation)) return;
  const Quat orientation = rotation_from_numbers(rotation, order);
  if (!(std::abs(orientation.norm() - 1) < 0.01))
    row.csv.fail(row.line, item.name + ".Rotation", "is not a quaternion of unit length");
  bodies.position(i, k) = metres * Vec3(position[0], position[1], position[2]);
  bodies.orientation(i, k) = orientation.normalized();
}

/// Returns the box, in a body's frame, around the mean positions of the markers BODY:… and BODY_….
Eigen::AlignedBox3d extent_of(const MarkerStream& markers, const BodyStream& bodies,
                              std::size_t body) {
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    const std::string& name = markers.names[k];
    const std::string& owner = bodies.names[body];
    if (name.size() <= owner.size() + 1 || !name.starts_with(owner)) continue;
    if (name[owner.size()] != ':' && name[owner.size()] != '_') continue;
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::size_t i = 0; i < markers.time.size(); ++i) {
      const Vec3 in_body = bodies.orientation(i, body).conjugate() *
                           (markers.position(i, k) - bodies.position(i, body));
      if (!is_known(in_body)) continue;
      sum += in_body;
      ++count;
    }
    if (count > 0) box.extend(Vec3(sum / count));
  }
  return box;
}

void report_gaps(const std::vector<double>& time, double rate_hz,
                 std::vector<std::string>& reports) {
  if (!(rate_hz > 0)) return;
  int gaps = 0;
  double missing = 0;  // frames
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double gap_frames = std::round((time[i] - time[i - 1]) * rate_hz) - 1;
    if (gap_frames < 1) continue;
    ++gaps;
    missing += gap_frames;
  }
  if (gaps > 0)
    add_note(reports, "{:.0f} frames are missing in {}", missing, count_with_noun(gaps, "gap"));
}

void report_take_contents(const OptitrackHeader& header, const Take& take,
                          std::vector<std::string>& reports) {
  if (!take.measured.empty() && !take.solved.empty())
    reports.push_back("measured marker positions used, not those computed from the rigid bodies");
  if (take.unlabelled > 0)
    add_note(reports, "{} skipped", count_with_noun(take.unlabelled, "unlabelled marker"));
  if (!take.other_types.empty())
    add_note(reports, "columns skipped: {}", fmt::join(take.other_types, ", "));
  if (const std::string start = header.value("Capture Start Time"); !start.empty())
    add_note(reports, "recorded at {} (time from the file)", start);
}

MarkerRecording read_take(const std::filesystem::path& file, const Conventions& conventions) {
  const files::CsvText csv = files::read_table(file);
  const OptitrackHeader header = read_optitrack_header(csv);
  if (csv.lines.size() <= header.line)
    csv.fail(csv.lines.size(), "", "ends before the first frame");
  const Take take = sort_items(header);
  const Items markers = markers_of(take);
  const std::string order = header.value("Rotation Type");
  check_rotation_order(csv, order, take.bodies);
  MarkerRecording recording;
  recording.import_notes = csv.notes;
  recording.unit_m = resolve_unit_m(header.value("Length Units"), conventions,
                                    fmt::format("{}:1", csv.file), recording.import_notes);
  const double metres = recording.unit_m;
  const std::string rate = header.value("Export Frame Rate");
  const double in_file = rate.empty() ? 0 : csv.number(1, "Export Frame Rate", rate);
  double rate_hz = 0;  // 0: the times in the file are used
  if (in_file > 0 || conventions.rate_hz)
    rate_hz = resolve_rate_hz(in_file, conventions, csv.file, recording.import_notes);
  const std::size_t rows = csv.lines.size() - header.line;
  std::vector<std::string> body_names;
  for (const OptitrackItem* item : take.bodies) body_names.push_back(item->name);
  recording.bodies.poses = unseen_body(body_names, rows);
  BodyStream& bodies = recording.bodies.poses;
  MarkerStream& stream = recording.markers;
  for (const OptitrackItem* item : markers) stream.names.push_back(item->name);
  stream.position = Array2D<Vec3>(rows, markers.size(), unknown_point());
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t line = header.line + 1 + i;
    const TakeRow row{csv, line, csv.cells(line)};
    if (row.cells.size() < header.cells) {
      csv.fail(
          line, "",
          fmt::format("the row has {} cells, the header has {}", row.cells.size(), header.cells));
    }
    const double frame = csv.number(line, "Frame", row.cells[0]);
    const double time_s = rate_hz > 0 ? frame / rate_hz : csv.number(line, "Time", row.cells[1]);
    add_time(time_s, csv.file, line, "Frame", stream.time);
    for (std::size_t k = 0; k < markers.size(); ++k) {
      const auto p = row.numbers(*markers[k], "Position", markers[k]->position);
      if (!p.empty()) stream.position(i, k) = metres * Vec3(p[0], p[1], p[2]);
    }
    for (std::size_t k = 0; k < take.bodies.size(); ++k)
      read_body(row, *take.bodies[k], order, metres, bodies, i, k);
  }
  bodies.time = stream.time;
  for (std::size_t k = 0; k < bodies.names.size(); ++k) {
    recording.bodies.extent.push_back(extent_of(stream, bodies, k));
    recording.bodies.bone.push_back(take.bodies[k]->type == "Bone");
  }
  report_take_contents(header, take, recording.import_notes);
  report_gaps(stream.time, rate_hz, recording.import_notes);
  return recording;
}

}  // namespace

bool recognises_optitrack_csv(std::string_view head) {
  return files::first_line_with_commas(head).starts_with("Format Version,");
}

Demonstration read_optitrack_csv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_take, "x -z y");
}

}  // namespace morphe::imports
