#include "stages/import/formats/capture_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/files/table_text.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/formats/capture_table.hpp"
#include "stages/import/formats/glove_columns.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/recording/unseen_points.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;

struct CaptureFrame {
  const files::CsvText& csv;
  Eigen::Matrix3d world_from_recorded;
  double metres;  ///< in one unit of a column without a suffix
};

bool is_complete(std::span<const double> values, std::span<const int> columns) {
  return std::ranges::all_of(columns, [&](int column) { return std::isfinite(values[column]); });
}

Vec3 position_of(const CaptureFrame& frame, const Columns::Body& body,
                 std::span<const double> values, double metres) {
  const Vec3 recorded(values[body.position[0]], values[body.position[1]], values[body.position[2]]);
  return frame.world_from_recorded * (metres * recorded);
}

struct Repairs {
  int normalised = 0, zero = 0;
  double max_norm_error = 0;
};

Quat rotation_of(const CaptureFrame& frame, const Columns::Body& body, std::size_t row,
                 std::span<const double> values, Repairs& repairs) {
  const auto value = [&](int k) { return values[body.rotation[k]]; };
  Quat recorded;
  if (body.rotation_format == Columns::RotationFormat::quaternion) {
    if (!is_complete(values, body.rotation)) return unknown_rotation();
    recorded = Quat(value(0), value(1), value(2), value(3));
    const double norm = recorded.norm(), norm_error = std::abs(norm - 1);
    if (norm == 0) {
      ++repairs.zero;
      return unknown_rotation();
    }
    constexpr double kMaxNormError = 0.02, kNormRoundingTolerance = 1e-6;
    if (!(norm_error < kMaxNormError)) {
      frame.csv.fail(row + 2, body.name,
                     fmt::format("its quaternion has norm {:.4g}, must be 1", norm));
    }
    if (norm_error > kNormRoundingTolerance) ++repairs.normalised;
    repairs.max_norm_error = std::max(repairs.max_norm_error, norm_error);
    recorded.normalize();
  } else {
    const std::span<const int> angles(body.rotation.data(), 3);
    if (!is_complete(values, angles)) return unknown_rotation();
    for (int k = 0; k < 3; ++k) {
      if (std::abs(value(k) * body.radians_per_unit) > 2 * std::numbers::pi + 0.01) {
        frame.csv.fail(row + 2, body.name,
                       "an angle is more than 360 degrees; is the unit correct?");
      }
    }
    recorded = Eigen::AngleAxisd(value(0) * body.radians_per_unit, Vec3::UnitZ()) *
               Eigen::AngleAxisd(value(1) * body.radians_per_unit, Vec3::UnitY()) *
               Eigen::AngleAxisd(value(2) * body.radians_per_unit, Vec3::UnitX());
  }
  return Quat(frame.world_from_recorded) * recorded;
}

void read_bodies(const CaptureFrame& frame, const Columns& columns, const CaptureTable& rows,
                 Streams& streams, std::vector<std::string>& reports) {
  const std::size_t n = rows.time.size();
  const auto fill = [&](const std::vector<Columns::Body>& bodies, auto& stream) {
    stream.time = rows.time;
    stream.position = Array2D<Vec3>(n, bodies.size(), unknown_point());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Columns::Body& body = bodies[k];
      stream.names.push_back(body.name);
      const double metres =
          body.unit.empty() ? frame.metres : metres_per_unit(body.unit, frame.csv.file);
      for (std::size_t i = 0; i < n; ++i)
        stream.position(i, k) = position_of(frame, body, rows[i], metres);
    }
    hide_fillers(frame.metres, stream.position, reports);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (!any_known(stream.position, k)) add_note(reports, "{} is never visible", stream.names[k]);
    }
    constexpr double kMaxSensorDistance_m = 30;
    for (const Vec3& point : stream.position.values) {
      if (point.norm() > kMaxSensorDistance_m) {
        throw InputError(
            fmt::format("{}: unit: a sensor is {:.3g} m from the origin; is the unit correct?",
                        frame.csv.file, point.norm()));
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
    for (std::size_t i = 0; i < n; ++i)
      bodies.orientation(i, k) = rotation_of(frame, columns.bodies[k], i, rows[i], repairs);
  }
  if (repairs.normalised > 0) {
    add_note(reports, "{} quaternions normalised; their norm differed from 1 by up to {:.2g}",
             repairs.normalised, repairs.max_norm_error);
  }
  if (repairs.zero > 0)
    add_note(reports, "{} quaternions are zero; treated as not visible", repairs.zero);
}

CaptureFrame capture_frame_of(const files::CsvText& csv, const Columns& columns,
                              const Conventions& conventions, std::vector<std::string>& reports) {
  if (conventions.axes.empty()) throw_unknown_axes(csv.file);
  CaptureFrame frame{csv, world_from_recorded(conventions.axes, csv.file), 1};
  bool lacks_unit = false, has_other_unit = false;
  for (const auto* bodies : {&columns.bodies, &columns.points}) {
    for (const Columns::Body& body : *bodies) {
      lacks_unit |= body.unit.empty();
      has_other_unit |=
          !body.unit.empty() && !conventions.unit.empty() && body.unit != conventions.unit;
    }
  }
  if (lacks_unit) frame.metres = resolve_unit_m("", conventions, csv.file, reports);
  if (has_other_unit) {
    add_note(reports, "some columns state their unit; the given {} is used only for the others",
             conventions.unit);
  }
  return frame;
}

}  // namespace

Streams read_capture_file(const std::filesystem::path& file, const RecordingFiles& files,
                          std::vector<std::string>& used, std::vector<std::string>& reports) {
  const files::CsvText csv = files::read_table(file);
  const Columns columns = read_capture_columns(csv, files.name_map, used);
  std::vector<std::string> notes = csv.notes;
  notes.insert(notes.end(), columns.notes.begin(), columns.notes.end());
  const bool has_positions = !columns.bodies.empty() || !columns.points.empty();
  if (!has_positions && columns.glove.empty()) {
    csv.fail(1, "",
             "has neither columns of a tracked body (NAME_x_m …, NAME_qw …) nor of a glove sensor");
  }
  double rate_hz = 0;
  if (columns.time == Columns::kNoColumn) {
    if (columns.frame == Columns::kNoColumn) csv.fail(1, "time_s", "the column is missing");
    rate_hz = resolve_rate_hz(0, files.conventions, csv.file, notes);
    add_note(notes, "time computed from the frame numbers, {} frames per second", rate_hz);
  }
  if (!columns.left_out.empty())
    add_note(notes, "columns skipped: {}", fmt::join(columns.left_out, ", "));
  const CaptureTable rows = read_capture_table(csv, columns, rate_hz);
  Streams streams;
  if (has_positions) {
    const CaptureFrame frame = capture_frame_of(csv, columns, files.conventions, notes);
    read_bodies(frame, columns, rows, streams, notes);
  }
  if (!columns.glove.empty()) {
    std::map<std::string, SensorCalibration> calibration;
    if (!files.glove_calibration.empty())
      calibration = read_glove_calibration(files.glove_calibration);
    streams.hand = read_glove_columns(csv, columns, rows, calibration, notes);
  }
  for (const std::string& note : notes) add_note(reports, "{}: {}", file.filename().string(), note);
  return streams;
}

}  // namespace morphe::imports
