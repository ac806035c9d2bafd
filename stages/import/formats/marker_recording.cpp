#include "stages/import/formats/marker_recording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/extract_joints.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/import/trackers/hand_checks.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/world_checks.hpp"

namespace morphe::imports {
namespace {

constexpr double kMaxMarkerSpread_m = 30, kMinMarkerSpread_m = 0.002;  // [m]

/// Returns the diagonal of the box around all seen points, NaN if no point was seen.
double extent(const Array2D<Vec3>& position) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : position.values) {
    if (is_known(point)) box.extend(point);
  }
  return box.isEmpty() ? kUnknown : box.diagonal().norm();
}

void hide_points_at_origin(MarkerRecording& recording) {
  std::size_t hidden = 0;
  for (Vec3& point : recording.markers.position.values) {
    if (!point.isZero(0)) continue;
    point = unknown_point();
    ++hidden;
  }
  if (hidden > 0) {
    recording.import_notes.push_back(
        fmt::format("{} points are exactly at the origin; treated as not visible", hidden));
  }
}

bool ever_seen(const MarkerStream& markers, std::size_t k) {
  for (std::size_t i = 0; i < markers.time.size(); ++i) {
    if (is_known(markers.position(i, k))) return true;
  }
  return false;
}

void report_never_seen(MarkerRecording& recording) {
  const MarkerStream& markers = recording.markers;
  std::vector<std::string> never;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    if (!ever_seen(markers, k)) never.push_back(markers.names[k]);
  }
  if (markers.names.empty()) return;
  if (never.size() == markers.names.size()) {
    recording.import_notes.push_back("no marker is visible in any frame");
  } else if (!never.empty()) {
    recording.import_notes.push_back(fmt::format("never visible: {}", fmt::join(never, ", ")));
  }
}

/// Reports a missing static trial: joints are located by it, or by landmarks in the recording
/// itself.
void report_no_static(Demonstration& demonstration) {
  if (!demonstration.streams.markers || demonstration.streams.skeleton) return;
  const MarkerStream& markers = *demonstration.streams.markers;
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    if (ever_seen(markers, k)) parts.push_back(body_part(markers.names[k]));
  }
  const auto any = [&](std::string_view end) {
    return std::ranges::any_of(parts, [&](const auto& part) { return part.ends_with(end); });
  };
  if (!any("upper arm") && !any("forearm")) return;
  if (any("elbow, outer") && any("elbow, inner") && any("wrist, thumb") && any(" shoulder")) return;
  demonstration.import_notes.push_back(
      "no static trial: joint centres are estimated from the relative rotation of marker clusters; "
      "in the shipped "
      "trials this displaced the shoulder by 39 to 65 mm, elbow and wrist by up to 25 mm; give one "
      "with --static-trial or `static_trial:`");
}

void bring_into_world(MarkerRecording& recording, const std::string& source,
                      const std::string& given, const std::string& usual) {
  std::string axes = given;
  if (axes.empty()) axes = recording.axes;
  if (axes.empty() && !usual.empty()) {
    axes = usual;
    recording.import_notes.push_back(
        fmt::format("axes not in the file; assumed '{}' (right, forward, up)", usual));
  }
  if (axes.empty()) {
    throw UnresolvedConvention(
        "axes", fmt::format("{}: axes: the file does not state which axes point right, forward and "
                            "up; give --axes or `axes:` such as 'x y z'",
                            source));
  }
  const Eigen::Matrix3d turn = world_from_recorded(axes, source);
  for (Vec3& point : recording.markers.position.values) point = turn * point;
  for (Vec3& point : recording.bodies.poses.position.values) point = turn * point;
  for (Quat& rotation : recording.bodies.poses.orientation.values) {
    rotation = (Quat(turn) * rotation).normalized();
  }
  recording.axes = axes;
}

void check_extent(const MarkerRecording& recording, const std::string& source) {
  const double apart = extent(recording.markers.position);
  const bool whole_hand = recording.markers.names.size() >= 3;
  if (apart > kMaxMarkerSpread_m || (whole_hand && apart > 0 && apart < kMinMarkerSpread_m)) {
    throw UnresolvedConvention(
        "unit",
        fmt::format(
            "{}: unit: implausible: the markers extend over {:.3g} m; give --unit or `unit:`",
            source, apart));
  }
}

MarkerRecording read_into_world(const std::filesystem::path& file, const RecordingFiles& files,
                                MarkerRecording (*read)(const std::filesystem::path&,
                                                        const Conventions&),
                                const std::string& usual_axes) {
  MarkerRecording recording = read(file, files.conventions);
  hide_points_at_origin(recording);
  bring_into_world(recording, file.string(), files.conventions.axes, usual_axes);
  if (files.conventions.plausibility_checks) check_extent(recording, file.string());
  return recording;
}

/// Applies a name map; markers and bodies share one set of names.
void rename_all(const std::string& file, const std::map<std::string, std::string>& renamed,
                MarkerRecording& recording) {
  std::vector<std::string>&markers = recording.markers.names,
  &bodies = recording.bodies.poses.names;
  std::vector<std::string> all = markers;
  all.insert(all.end(), bodies.begin(), bodies.end());
  apply_name_map(file, renamed, all);
  const auto first_body = all.begin() + markers.size();
  markers.assign(all.begin(), first_body);
  bodies.assign(first_body, all.end());
}

bool has(const MarkerRecording& recording, const std::string& name) {
  const auto among = [&](const std::vector<std::string>& names) {
    return std::ranges::find(names, name) != names.end();
  };
  return among(recording.markers.names) || among(recording.bodies.poses.names);
}

/// Applies the name map to a recording and its static trial, either of which may lack markers of
/// the other.
void rename_both(const RecordingFiles& files, MarkerRecording& recording, MarkerRecording& still) {
  std::map<std::string, std::string> here, there;
  for (const auto& entry : files.name_map) {
    const bool in_still = has(still, entry.first);
    if (in_still) there.insert(entry);
    if (has(recording, entry.first) || !in_still) here.insert(entry);
  }
  rename_all(files.file.string(), here, recording);
  rename_all(files.static_trial.string(), there, still);
}

/// Checks points that are named as joints like a tracker's hands.
void check_joints(const RecordingFiles& files, Demonstration& demonstration) {
  if (!demonstration.streams.skeleton) return;
  HandClip clip;
  clip.body = *demonstration.streams.skeleton;
  clip.time = clip.body.time;
  clip.objects = demonstration.objects;
  for (const Side side : {Side::right, Side::left}) {
    const std::string knuckle = std::string(name_of(side)) + "_middle_mcp";
    if (std::ranges::find(clip.body.names, knuckle) == clip.body.names.end()) continue;
    clip.hands[static_cast<std::size_t>(side)] = unseen_hand(clip.time.size());
  }
  std::vector<std::string>& reports = demonstration.import_notes;
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  check_world(clip, reports);
}

}  // namespace

Demonstration read_marker_recording(const RecordingFiles& files,
                                    MarkerRecording (*read)(const std::filesystem::path&,
                                                            const Conventions&),
                                    const std::string& usual_axes) {
  MarkerRecording recording = read_into_world(files.file, files, read, usual_axes),
                  static_recording;
  if (!files.static_trial.empty()) {
    static_recording = read_into_world(files.static_trial, files, read, usual_axes);
  }
  rename_both(files, recording, static_recording);
  Demonstration demonstration;
  demonstration.subject = recording.subject;
  report_never_seen(recording);
  demonstration.import_notes = recording.import_notes;
  if (!recording.markers.names.empty() || recording.bodies.poses.names.empty()) {
    demonstration.streams.markers = std::move(recording.markers);
    extract_joints(files.hand, demonstration);
  }
  add_rigid_bodies(recording.bodies, demonstration);
  check_joints(files, demonstration);
  if (files.static_trial.empty()) report_no_static(demonstration);
  if (!files.static_trial.empty()) {
    report_never_seen(static_recording);
    for (const std::string& report : static_recording.import_notes) {
      demonstration.import_notes.push_back("static trial: " + report);
    }
    demonstration.calibration.markers = std::move(static_recording.markers);
  }
  return demonstration;
}

}  // namespace morphe::imports
