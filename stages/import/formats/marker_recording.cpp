#include "stages/import/formats/marker_recording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/formats/extract_joints.hpp"
#include "stages/import/recording/apply_name_map.hpp"
#include "stages/import/recording/arm_names.hpp"
#include "stages/import/recording/assumption_notes.hpp"
#include "stages/import/recording/repeated_names.hpp"
#include "stages/import/recording/unseen_points.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_checks.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/world_checks.hpp"

namespace morphe::imports {
namespace {

constexpr double kMaxMarkerSpread_m = 30, kMinMarkerSpread_m = 0.002;

/// Returns the diagonal of the box around all seen points, NaN if no point was seen.
double extent(const Array2D<Vec3>& position) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : position.values) {
    if (is_known(point)) box.extend(point);
  }
  return box.isEmpty() ? kUnknown : box.diagonal().norm();
}

/// Numbers names that stand more than once, and renames markers that are called as a body: a bone
/// and a marker on it are two things, and the bone is the one of which an arm is made.
void distinguish_names(MarkerRecording& recording) {
  number_repeated_names(recording.bodies.poses.names, recording.import_notes);
  for (std::string& name : recording.markers.names) {
    if (name_index(recording.bodies.poses.names, name) < 0) continue;
    add_note(
        recording.import_notes,
        "{} is the name of a bone or rigid body and of a marker; the marker is called {}_marker",
        name, name);
    name += "_marker";
  }
  number_repeated_names(recording.markers.names, recording.import_notes);
}

void report_never_seen(MarkerRecording& recording) {
  const MarkerStream& markers = recording.markers;
  std::vector<std::string> never_seen;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    if (!any_known(markers.position, k)) never_seen.push_back(markers.names[k]);
  }
  if (never_seen.empty()) return;
  if (never_seen.size() == markers.names.size()) {
    recording.import_notes.push_back("no marker is visible in any frame");
  } else {
    add_note(recording.import_notes, "never visible: {}", fmt::join(never_seen, ", "));
  }
}

/// Reports that there is no static trial to locate the joints, unless the recording has landmarks.
void report_no_static(Demonstration& demonstration) {
  if (!demonstration.streams.markers || demonstration.streams.skeleton) return;
  const MarkerStream& markers = *demonstration.streams.markers;
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < markers.names.size(); ++k) {
    if (any_known(markers.position, k)) parts.push_back(body_part(markers.names[k]));
  }
  const auto any = [&](std::string_view end) {
    return std::ranges::any_of(parts, [&](const auto& part) { return part.ends_with(end); });
  };
  if (!any("upper arm") && !any("forearm")) return;
  if (any("elbow, outer") && any("elbow, inner") && any("wrist, thumb") && any(" shoulder")) return;
  add_note(demonstration.import_notes,
           "{} are estimated from the relative rotation of marker clusters; in the shipped trials "
           "this displaced the shoulder by 39 to 65 mm, elbow and wrist by up to "
           "25 mm; give one with --static-trial or `static_trial:`",
           kNoStaticTrialEstimate);
}

void bring_into_world(MarkerRecording& recording, const std::string& source,
                      const std::string& given_axes, const std::string& usual_axes) {
  std::string axes = given_axes.empty() ? recording.axes : given_axes;
  if (axes.empty()) {
    if (usual_axes.empty()) throw_unknown_axes(source);
    axes = usual_axes;
    add_note(recording.import_notes, "{} '{}' (right, forward, up)", kAxesAssumed, axes);
  }
  const bool points_only = recording.bodies.poses.names.empty();
  const Eigen::Matrix3d world_from_file =
      points_only ? world_from_points(axes, source) : world_from_recorded(axes, source);
  if (world_from_file.determinant() < 0)
    add_note(recording.import_notes, "the axes '{}' are left-handed: the points are mirrored",
             axes);
  for (Vec3& point : recording.markers.position.values) point = world_from_file * point;
  for (Vec3& point : recording.bodies.poses.position.values) point = world_from_file * point;
  for (Quat& rotation : recording.bodies.poses.orientation.values)
    rotation = (Quat(world_from_file) * rotation).normalized();
}

void check_extent(const MarkerRecording& recording, const std::string& source) {
  const double extent_m = extent(recording.markers.position);
  const bool may_be_hand = recording.markers.names.size() >= 3;
  if (extent_m > kMaxMarkerSpread_m ||
      (may_be_hand && extent_m > 0 && extent_m < kMinMarkerSpread_m)) {
    throw UnresolvedConvention(
        "unit",
        fmt::format(
            "{}: unit: implausible: the markers extend over {:.3g} m; give --unit or `unit:`",
            source, extent_m));
  }
}

/// Flags a static trial whose file names another person than that of the recording.
void compare_subjects(const std::string& own, const std::string& of_static,
                      std::vector<RecordingFlag>& flags) {
  if (own.empty() || of_static.empty() || own == of_static) return;
  flags.push_back(
      {.code = FlagCode::static_trial,
       .subject = of_static,
       .text = fmt::format("the static trial names its person {}, the recording {}: it is another "
                           "person's",
                           of_static, own)});
}

MarkerRecording read_into_world(const std::filesystem::path& file, const RecordingFiles& files,
                                MarkerReader read, const std::string& usual_axes) {
  MarkerRecording recording = read(file, files.conventions);
  distinguish_names(recording);
  hide_points_at_origin(recording.markers.position, recording.import_notes);
  hide_fillers(recording.unit_m, recording.markers.position, recording.import_notes);
  bring_into_world(recording, file.string(), files.conventions.axes, usual_axes);
  if (files.conventions.plausibility_checks) check_extent(recording, file.string());
  return recording;
}

/// Applies a name map to markers and bodies together, whose resulting names must differ.
void rename_all(const std::string& file, const std::map<std::string, std::string>& renamed,
                MarkerRecording& recording) {
  std::vector<std::string>& markers = recording.markers.names;
  std::vector<std::string>& bodies = recording.bodies.poses.names;
  std::vector<std::string> all = markers;
  all.insert(all.end(), bodies.begin(), bodies.end());
  apply_name_map(file, renamed, all);
  const auto first_body = all.begin() + markers.size();
  markers.assign(all.begin(), first_body);
  bodies.assign(first_body, all.end());
}

bool has_name(const MarkerRecording& recording, const std::string& name) {
  return name_index(recording.markers.names, name) >= 0 ||
         name_index(recording.bodies.poses.names, name) >= 0;
}

/// Applies the name map to recording and static trial; a name may be in only one of them.
void rename_both(const RecordingFiles& files, MarkerRecording& recording,
                 MarkerRecording& static_recording) {
  std::map<std::string, std::string> recording_map, static_map;
  for (const auto& entry : files.name_map) {
    const bool in_static = has_name(static_recording, entry.first);
    if (in_static) static_map.insert(entry);
    if (has_name(recording, entry.first) || !in_static) recording_map.insert(entry);
  }
  rename_all(files.file.string(), recording_map, recording);
  rename_all(files.static_trial.string(), static_map, static_recording);
}

/// Checks the skeleton as hands of a tracker. The hands are empty: their joints are in the body.
void check_joints(const RecordingFiles& files, Demonstration& demonstration) {
  if (!demonstration.streams.skeleton) return;
  HandClip clip;
  clip.body = *demonstration.streams.skeleton;
  clip.time = clip.body.time;
  clip.objects = demonstration.objects;
  for (const Side side : {Side::right, Side::left}) {
    const std::string knuckle = std::string(name_of(side)) + "_middle_mcp";
    if (name_index(clip.body.names, knuckle) < 0) continue;
    clip.hands[side_index(side)] = unseen_hand(clip.time.size());
  }
  std::vector<std::string>& reports = demonstration.import_notes;
  check_hands(files.file.string(), clip, files.conventions.plausibility_checks, reports);
  check_world(clip, reports);
}

}  // namespace

Demonstration read_marker_recording(const RecordingFiles& files, MarkerReader read,
                                    const std::string& usual_axes) {
  MarkerRecording recording = read_into_world(files.file, files, read, usual_axes);
  MarkerRecording static_recording;
  if (!files.static_trial.empty())
    static_recording = read_into_world(files.static_trial, files, read, usual_axes);
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
  if (files.static_trial.empty()) {
    report_no_static(demonstration);
    return demonstration;
  }
  compare_subjects(recording.subject, static_recording.subject, demonstration.flags);
  report_never_seen(static_recording);
  for (const std::string& note : static_recording.import_notes)
    demonstration.import_notes.push_back("static trial: " + note);
  demonstration.calibration.markers = std::move(static_recording.markers);
  return demonstration;
}

}  // namespace morphe::imports
