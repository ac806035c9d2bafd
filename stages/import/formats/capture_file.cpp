#include "stages/import/formats/capture_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/capture_table.hpp"
#include "stages/import/formats/glove_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;

/// The data shared by a file's bodies and points.
struct CaptureFrame {
  const files::CsvText& csv;
  Eigen::Matrix3d world_from_recorded;
  double metres;  ///< metres in one unit of a column without a suffix
};

/// Returns true if all values exist, false if all are missing; otherwise throws InputError.
bool is_complete(const files::CsvText& csv, std::size_t row, std::span<const double> values,
                 std::span<const std::size_t> columns, const std::string& key, const char* what) {
  std::size_t found = 0;
  for (const std::size_t c : columns) found += std::isfinite(values[c]) ? 1 : 0;
  if (found != 0 && found != columns.size()) {
    csv.fail(row + 2, key, fmt::format("has only some of {}", what));
  }
  return found != 0;
}

Vec3 position_of(const CaptureFrame& place, const Columns::Body& body, std::size_t row,
                 std::span<const double> values, double metres) {
  if (!is_complete(place.csv, row, values, body.position, body.name, "x, y, z"))
    return unknown_point();
  const Vec3 recorded(values[body.position[0]], values[body.position[1]], values[body.position[2]]);
  return place.world_from_recorded * (metres * recorded);
}

struct Repairs {
  std::size_t normalised = 0, zero = 0;
  double worst = 0;  ///< largest deviation from unit norm
};

Quat rotation_of(const CaptureFrame& place, const Columns::Body& body, std::size_t row,
                 std::span<const double> values, Repairs& repairs) {
  const auto at = [&](std::size_t k) { return values[body.rotation[k]]; };
  Quat recorded;
  if (body.rotation_format == Columns::RotationFormat::quaternion) {
    if (!is_complete(place.csv, row, values, body.rotation, body.name, "qw, qx, qy, qz")) {
      return unknown_rotation();
    }
    recorded = Quat(at(0), at(1), at(2), at(3));
    const double norm = recorded.norm(), off = std::abs(norm - 1);
    if (norm == 0) {
      ++repairs.zero;
      return unknown_rotation();
    }
    constexpr double kMaxNormError = 0.02, kNormRoundingTolerance = 1e-6;
    if (!(off < kMaxNormError)) {
      place.csv.fail(row + 2, body.name,
                     fmt::format("its quaternion has norm {:.4g}, must be 1", norm));
    }
    if (off > kNormRoundingTolerance) ++repairs.normalised;
    repairs.worst = std::max(repairs.worst, off);
    recorded.normalize();
  } else {
    const std::span<const std::size_t> angles(body.rotation.data(), 3);
    if (!is_complete(place.csv, row, values, angles, body.name, "azimuth, elevation, roll")) {
      return unknown_rotation();
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(at(k) * body.radians_per_unit) > 2 * std::numbers::pi + 0.01) {
        place.csv.fail(row + 2, body.name,
                       "an angle is more than 360 degrees; is the unit correct?");
      }
    }
    recorded = Eigen::AngleAxisd(at(0) * body.radians_per_unit, Vec3::UnitZ()) *
               Eigen::AngleAxisd(at(1) * body.radians_per_unit, Vec3::UnitY()) *
               Eigen::AngleAxisd(at(2) * body.radians_per_unit, Vec3::UnitX());
  }
  return Quat(place.world_from_recorded) * recorded;
}

void report_never_seen(const std::vector<std::string>& names, const Array2D<Vec3>& position,
                       std::vector<std::string>& reports) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    bool once = false;
    for (std::size_t i = 0; i < position.rows && !once; ++i) once = is_known(position(i, k));
    if (!once) reports.push_back(fmt::format("{} is never visible", names[k]));
  }
}

void read_bodies(const CaptureFrame& place, const Columns& columns, const CaptureTable& rows,
                 Streams& streams, std::vector<std::string>& reports) {
  const std::size_t n = rows.time.size();
  const auto metres = [&](const Columns::Body& body) {
    return body.unit.empty() ? place.metres : metres_per_unit(body.unit, place.csv.file);
  };
  const auto fill = [&](const std::vector<Columns::Body>& bodies, auto& stream) {
    stream.time = rows.time;
    stream.position = Array2D<Vec3>(n, bodies.size(), unknown_point());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      stream.names.push_back(bodies[k].name);
      const double unit = metres(bodies[k]);
      for (std::size_t i = 0; i < n; ++i) {
        stream.position(i, k) = position_of(place, bodies[k], i, rows[i], unit);
      }
    }
    report_never_seen(stream.names, stream.position, reports);
    constexpr double kMaxSensorDistance_m = 30;  // [m]
    for (const Vec3& point : stream.position.values) {
      if (point.norm() > kMaxSensorDistance_m) {
        throw InputError(
            fmt::format("{}: unit: a sensor is {:.3g} m from the origin; is the unit correct?",
                        place.csv.file, point.norm()));
      }
    }
  };
  if (!columns.points.empty()) fill(columns.points, streams.markers.emplace());
  if (columns.bodies.empty()) return;
  BodyStream& bodies = streams.sensors.emplace();
  fill(columns.bodies, bodies);
  bodies.orientation = Array2D<Quat>(n, columns.bodies.size(), unknown_rotation());
  Repairs repairs;
  for (std::size_t k = 0; k < columns.bodies.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      bodies.orientation(i, k) = rotation_of(place, columns.bodies[k], i, rows[i], repairs);
    }
  }
  if (repairs.normalised > 0) {
    reports.push_back(
        fmt::format("{} quaternions normalised; their norm differed from 1 by up to {:.2g}",
                    repairs.normalised, repairs.worst));
  }
  if (repairs.zero > 0) {
    reports.push_back(fmt::format("{} quaternions are zero; treated as not visible", repairs.zero));
  }
}

CaptureFrame capture_frame_of(const files::CsvText& csv, const Columns& columns,
                              const Conventions& conventions, std::vector<std::string>& reports) {
  if (conventions.axes.empty()) {
    throw UnresolvedConvention(
        "axes", fmt::format("{}: axes: the file does not state which axes point right, forward and "
                            "up; give --axes or `axes:` such as 'x y z'",
                            csv.file));
  }
  CaptureFrame place{csv, world_from_recorded(conventions.axes, csv.file), 1};
  bool unsaid = false, said_otherwise = false;
  for (const auto* bodies : {&columns.bodies, &columns.points}) {
    for (const Columns::Body& body : *bodies) {
      unsaid |= body.unit.empty();
      said_otherwise |=
          !body.unit.empty() && !conventions.unit.empty() && body.unit != conventions.unit;
    }
  }
  if (unsaid) place.metres = resolve_unit_m("", conventions, csv.file, reports);
  if (said_otherwise) {
    reports.push_back(
        fmt::format("some columns state their unit; the given {} is used only for the others",
                    conventions.unit));
  }
  return place;
}

}  // namespace

Streams read_capture_file(const std::filesystem::path& file, const RecordingFiles& files,
                          std::vector<std::string>& used, std::vector<std::string>& reports) {
  const files::CsvText csv = files::read_csv(file);
  const Columns columns = read_capture_columns(csv, files.name_map, used);
  std::vector<std::string> said = csv.notes;
  const bool placed = !columns.bodies.empty() || !columns.points.empty();
  if (!placed && columns.glove.empty()) {
    csv.fail(1, "",
             "has neither columns of a tracked body (NAME_x_m …, NAME_qw …) nor of a glove sensor");
  }
  double rate_hz = 0;
  if (columns.time == Columns::kNoColumn) {
    if (columns.frame == Columns::kNoColumn) csv.fail(1, "time_s", "the column is missing");
    rate_hz = resolve_rate_hz(0, files.conventions, csv.file, said);
    said.push_back(
        fmt::format("time computed from the frame numbers, {} frames per second", rate_hz));
  }
  if (!columns.left_out.empty()) {
    said.push_back(fmt::format("columns skipped: {}", fmt::join(columns.left_out, ", ")));
  }
  const CaptureTable rows = read_capture_table(csv, columns, rate_hz);
  Streams streams;
  if (placed) {
    const CaptureFrame place = capture_frame_of(csv, columns, files.conventions, said);
    read_bodies(place, columns, rows, streams, said);
  }
  if (!columns.glove.empty()) {
    std::map<std::string, SensorCalibration> calibration;
    if (!files.glove_calibration.empty()) {
      calibration = read_glove_calibration(files.glove_calibration);
    }
    streams.hand = read_glove_columns(csv, columns, rows, calibration, said);
  }
  for (const std::string& report : said) {
    reports.push_back(fmt::format("{}: {}", file.filename().string(), report));
  }
  return streams;
}

}  // namespace morphe::imports
