// Takes that OptiTrack's Motive exports as CSV: rigid bodies and markers. Line 1 contains pairs of
// a key and its value (format version, rates, units); then follow the types, names and IDs of the
// columns, their quantities, "Frame,Time…" above X, Y, Z and W, and a row per frame. A body or
// marker that was not seen has empty cells. Quaternions are x, y, z, w.
//
// Markers of one name occur twice: as given by the body's pose ("Rigid Body Marker") and as
// measured ("Marker"). The measured ones are used if there are any.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/motion/count_with_noun.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/optitrack_header.hpp"
#include "stages/import/formats/point_header.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/formats/rigid_bodies.hpp"

namespace morphe::imports {
namespace {

using Items = std::vector<const OptitrackItem*>;

/// A row of a take.
struct TakeRow {
  const files::CsvText& csv;
  std::size_t line;
  std::vector<std::string> cells;

  /// Returns the numbers of an item, empty if all cells are empty. Throws InputError if only some
  /// are.
  std::vector<double> numbers(const OptitrackItem& item, const char* quantity,
                              const std::vector<std::size_t>& columns) const {
    std::vector<double> values;
    for (const std::size_t c : columns) {
      if (cells[c].empty()) continue;
      values.push_back(csv.number(line, fmt::format("{}.{}", item.name, quantity), cells[c]));
    }
    if (!values.empty() && values.size() < columns.size()) {
      csv.fail(line, fmt::format("{}.{}", item.name, quantity), "has only some of its numbers");
    }
    return values;
  }
};

/// The items of a take by kind.
struct Take {
  Items bodies, measured, solved;
  std::size_t unlabelled = 0;
  std::set<std::string> others;  ///< other types, which are left out
};

Take sort_items(const OptitrackHeader& header) {
  Take take;
  for (const OptitrackItem& item : header.items) {
    if (item.name.starts_with("Unlabeled") || item.name.starts_with("Unlabelled")) {
      ++take.unlabelled;
    } else if ((item.type == "Rigid Body" || item.type == "Bone") && !item.position.empty() &&
               !item.rotation.empty()) {
      take.bodies.push_back(&item);
    } else if (item.type == "Marker" && !item.position.empty()) {
      take.measured.push_back(&item);
    } else if ((item.type == "Rigid Body Marker" || item.type == "Bone Marker") &&
               !item.position.empty()) {
      take.solved.push_back(&item);
    } else {
      take.others.insert(item.type);
    }
  }
  return take;
}

/// Returns the measured markers, and solved ones whose names are not among the measured.
Items markers_of(const Take& take) {
  Items markers = take.measured;
  const auto has = [&](const OptitrackItem* one) {
    return std::ranges::any_of(
        take.measured, [&](const OptitrackItem* other) { return other->name == one->name; });
  };
  std::ranges::remove_copy_if(take.solved, std::back_inserter(markers), has);
  return markers;
}

/// Returns a rotation from a quaternion or from Euler angles in degrees, which turn about the axes
/// in the order of their name, each about the body's own axis.
Quat rotation_from_numbers(const std::vector<double>& numbers, const std::string& order) {
  if (numbers.size() == 4) return Quat(numbers[3], numbers[0], numbers[1], numbers[2]);
  Quat turn = Quat::Identity();
  for (const char axis : order) {
    const int k = axis - 'X';
    turn = turn * Eigen::AngleAxisd(numbers[k] * kRadPerDegree, Vec3::Unit(k));
  }
  return turn;
}

void check_rotations(const files::CsvText& csv, const OptitrackHeader& header,
                     const std::string& order, const Items& bodies) {
  const bool euler =
      std::ranges::any_of(bodies, [](const auto* b) { return b->rotation.size() == 3; });
  if (!euler) return;
  std::string axes = order;
  std::ranges::sort(axes);
  if (axes != "XYZ") {
    csv.fail(1, "Rotation Type",
             fmt::format("must be Quaternion or an order such as XYZ, not '{}'",
                         header.value("Rotation Type")));
  }
}

void read_body(const TakeRow& row, const OptitrackItem& item, const std::string& order,
               double metres, BodyStream& bodies, std::size_t i, std::size_t k) {
  const std::vector<double> position = row.numbers(item, "Position", item.position);
  const std::vector<double> rotation = row.numbers(item, "Rotation", item.rotation);
  if (position.empty() || rotation.empty()) return;
  const Quat turn = rotation_from_numbers(rotation, order);
  if (!(std::abs(turn.norm() - 1) < 0.01)) {
    row.csv.fail(row.line, fmt::format("{}.Rotation", item.name),
                 "is not a quaternion of unit length");
  }
  bodies.position(i, k) = metres * Vec3(position[0], position[1], position[2]);
  bodies.orientation(i, k) = turn.normalized();
}

double time_of(const TakeRow& row, double rate_hz) {
  const double frame = row.csv.number(row.line, "Frame", row.cells[0]);
  return rate_hz > 0 ? frame / rate_hz : row.csv.number(row.line, "Time", row.cells[1]);
}

/// Returns the box around a body's markers in its own frame: those named BODY:… or BODY_….
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
  std::size_t gaps = 0;
  double missing = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double skipped = std::round((time[i] - time[i - 1]) * rate_hz) - 1;
    if (skipped < 1) continue;
    ++gaps;
    missing += skipped;
  }
  if (gaps > 0) {
    reports.push_back(
        fmt::format("{:.0f} frames are missing in {}", missing, count_with_noun(gaps, "gap")));
  }
}

std::string unit_of(const OptitrackHeader& header) {
  const std::string said = header.value("Length Units");
  if (said == "Meters") return "m";
  if (said == "Centimeters") return "cm";
  if (said == "Millimeters") return "mm";
  if (said == "Inches") return "in";
  if (said == "Feet") return "ft";
  return said;
}

void report_take_contents(const OptitrackHeader& header, const Take& take,
                          std::vector<std::string>& reports) {
  if (!take.measured.empty() && !take.solved.empty()) {
    reports.push_back("measured marker positions used, not those computed from the rigid bodies");
  }
  if (take.unlabelled > 0) {
    reports.push_back(
        fmt::format("{} skipped", count_with_noun(take.unlabelled, "unlabelled marker")));
  }
  if (!take.others.empty()) {
    reports.push_back(fmt::format("columns skipped: {}", fmt::join(take.others, ", ")));
  }
  if (const std::string began = header.value("Capture Start Time"); !began.empty()) {
    reports.push_back(fmt::format("recorded at {} (time from the file)", began));
  }
}

MarkerRecording read_take(const std::filesystem::path& file, const Conventions& conventions) {
  const files::CsvText csv = files::read_csv(file);
  const OptitrackHeader header = read_optitrack_header(csv);
  if (csv.lines.size() <= header.line)
    csv.fail(csv.lines.size(), "", "ends before the first frame");
  const Take take = sort_items(header);
  const Items markers = markers_of(take);
  const std::string order = header.value("Rotation Type");
  check_rotations(csv, header, order, take.bodies);
  MarkerRecording recording;
  recording.import_notes = csv.notes;
  const double metres = resolve_unit_m(unit_of(header), conventions, fmt::format("{}:1", csv.file),
                                       recording.import_notes);
  const std::string said_rate = header.value("Export Frame Rate");
  const double in_file = said_rate.empty() ? 0 : csv.number(1, "Export Frame Rate", said_rate);
  const double rate_hz =
      in_file > 0 || conventions.rate_hz
          ? resolve_rate_hz(in_file, conventions, csv.file, recording.import_notes)
          : 0;
  const std::size_t rows = csv.lines.size() - header.line;
  MarkerStream& stream = recording.markers;
  BodyStream& bodies = recording.bodies.poses;
  for (const OptitrackItem* item : markers) stream.names.push_back(item->name);
  for (const OptitrackItem* item : take.bodies) bodies.names.push_back(item->name);
  stream.position = Array2D<Vec3>(rows, markers.size(), unknown_point());
  bodies.position = Array2D<Vec3>(rows, take.bodies.size(), unknown_point());
  bodies.orientation = Array2D<Quat>(rows, take.bodies.size(), unknown_rotation());
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t line = header.line + 1 + i;
    const TakeRow row{csv, line, quoted_cells(csv.lines[line - 1], csv.separator)};
    if (row.cells.size() < header.cells) {
      csv.fail(
          line, "",
          fmt::format("the row has {} cells, the header has {}", row.cells.size(), header.cells));
    }
    const double time_s = time_of(row, rate_hz);
    if (i > 0 && !(time_s > stream.time.back())) {
      csv.fail(line, "Frame", "must be greater than in the previous row");
    }
    stream.time.push_back(time_s);
    for (std::size_t k = 0; k < markers.size(); ++k) {
      const auto at = row.numbers(*markers[k], "Position", markers[k]->position);
      if (!at.empty()) stream.position(i, k) = metres * Vec3(at[0], at[1], at[2]);
    }
    for (std::size_t k = 0; k < take.bodies.size(); ++k) {
      read_body(row, *take.bodies[k], order, metres, bodies, i, k);
    }
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
  return head.starts_with("Format Version,") || head.starts_with("\"Format Version\",");
}

Demonstration read_optitrack_csv(const RecordingFiles& files) {
  return read_marker_recording(files, &read_take, "x -z y");
}

}  // namespace morphe::imports
