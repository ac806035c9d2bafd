// C3D: points of a motion capture system. The file does not contain the heading of the subject; if
// it contains the orientation of the laboratory on a screen (POINT:X_SCREEN, Y_SCREEN), the subject
// is assumed to look into that screen, which is reported.
#include <fmt/format.h>

#include <cctype>

#include "stages/import/formats/c3d_file.hpp"
#include "stages/import/formats/marker_recording.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

/// Returns the unit vector that "+X", "-Z" or "Y" denotes; zero for other texts.
Vec3 axis_of(std::string text) {
  const double sign = text.starts_with('-') ? -1 : 1;
  if (text.starts_with('-') || text.starts_with('+')) text.erase(0, 1);
  if (text.size() != 1) return Vec3::Zero();
  const int index = std::toupper(static_cast<unsigned char>(text[0])) - 'X';
  return index < 0 || index > 2 ? Vec3(Vec3::Zero()) : Vec3(sign * Vec3::Unit(index));
}

MarkerRecording read_c3d_recording(const std::filesystem::path& file,
                                   const Conventions& conventions) {
  C3dPoints points = read_c3d_points(file);
  MarkerRecording recording;
  recording.import_notes = std::move(points.import_notes);
  const std::string source = file.string();
  recording.unit_m = resolve_unit_m(points.unit, conventions, source, recording.import_notes);
  const double rate_hz =
      resolve_rate_hz(points.rate_hz, conventions, source, recording.import_notes);
  const Vec3 right = axis_of(points.x_screen), up = axis_of(points.y_screen);
  const Vec3 forward = up.cross(right);
  if (conventions.axes.empty() && !forward.isZero()) {
    recording.axes = fmt::format("{} {} {}", axis_word(right), axis_word(forward), axis_word(up));
    add_note(recording.import_notes, "axes '{}' from POINT:X_SCREEN and Y_SCREEN; {}",
             recording.axes, kFacesScreen);
  }
  MarkerStream& markers = recording.markers;
  markers.names = std::move(points.labels);
  markers.position = std::move(points.position);
  for (Vec3& point : markers.position.values) point *= recording.unit_m;
  for (std::size_t i = 0; i < markers.position.rows; ++i)
    markers.time.push_back((static_cast<double>(points.first_frame + i) - 1) / rate_hz);
  return recording;
}

}  // namespace

bool recognises_c3d(std::string_view head) {
  return head.size() >= 2 && head[0] > 0 && head[1] == 0x50 && head.find('\0') != head.npos;
}

Demonstration read_c3d(const RecordingFiles& files) {
  return read_marker_recording(files, &read_c3d_recording);
}

}  // namespace morphe::imports
