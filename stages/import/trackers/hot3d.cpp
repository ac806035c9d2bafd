// A sequence of HOT3D: umetrack_hand_pose_trajectory.jsonl, with a line per camera frame that
// contains the wrist's pose and the joints' angles of both hands; and beside it
// umetrack_hand_user_profile.json (the person's hand), dynamic_objects.csv (poses of objects),
// headset_trajectory.csv, metadata.json (the headset, which determines the up axis) and the
// objects' meshes. Times are whole nanoseconds.
//
// The landmarks are computed from the wrist's pose, which is at the wrist joint. In the file for
// MANO's hand it is not, and MANO's model must not be redistributed, so that file is not read.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "core/collision/mesh_file.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/recording/json_lines.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/hot3d_poses.hpp"
#include "stages/import/trackers/readers.hpp"
#include "stages/import/trackers/umetrack_hand.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

/// Poses closer than this are of one frame, which cameras of a headset record 0.1 ms apart.
constexpr std::int64_t kSameFrame_ns = 10'000'000;

double seconds(std::int64_t from_ns, std::int64_t to_ns) {
  return static_cast<double>(to_ns - from_ns) / 1e9;
}

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error);
}

void read_hand(const JsonNode& pose, const UmetrackHand& model, Side side, std::size_t row,
               const TrackerFrame& frame, RecordedHand& hand) {
  const JsonNode wrist = pose.at("wrist_xform");
  const auto points = umetrack_forward_kinematics(
      model, side, make_pose(wrist.at("t_xyz").point(), wrist.at("q_wxyz").quaternion()),
      pose.at("joint_angles").numbers(UmetrackHand::kAngleCount));
  const double confidence = pose.has("hand_confidence") ? pose.at("hand_confidence").number() : 1.0;
  hand.confidence[row] = std::clamp(confidence, 0.0, 1.0);
  if (!(confidence > 0)) return;
  const KeypointOrder& order = *keypoint_order("aria");
  for (int k = 0; k < kKeypointCount; ++k) {
    if (order.joint[k] < 0) continue;
    hand.keypoints(row, k) = frame.point(points.landmarks[order.joint[k]]);
  }
  hand.keypoints(row, 1) = frame.point(points.thumb_cmc);
}

struct HandFrames {
  std::vector<std::int64_t> time_ns;
  RecordedHand hands[2];
  std::size_t duplicate_count = 0;
};

HandFrames read_hands(const fs::path& file, const UmetrackHand& model, const TrackerFrame& frame) {
  HandFrames frames;
  std::vector<std::int64_t>& stamps = frames.time_ns;
  std::vector<nlohmann::json> poses_of_lines;
  std::vector<std::size_t> line_numbers;
  each_json_line(file, [&](const JsonNode& line) {
    const JsonNode stamp = line.at("timestamp_ns");
    if (!stamp.value->is_number_integer()) stamp.fail("must be a whole number");
    const auto now = stamp.value->get<std::int64_t>();
    if (!stamps.empty() && now < stamps.back())
      stamp.fail("must be greater than in the previous line");
    if (!stamps.empty() && now - stamps.back() < kSameFrame_ns) {
      ++frames.duplicate_count;
      return;
    }
    stamps.push_back(now);
    poses_of_lines.push_back(*line.at("hand_poses").value);
    line_numbers.push_back(line.line);
  });
  for (RecordedHand& hand : frames.hands) {
    hand = unseen_hand(stamps.size());
    hand.confidence.assign(stamps.size(), 0);
  }
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const JsonNode poses{file.string(), line_numbers[i], "hand_poses", &poses_of_lines[i]};
    for (const auto& [key, side] : {std::pair("0", Side::left), std::pair("1", Side::right)}) {
      if (!poses.has(key)) continue;
      read_hand(poses.at(key), model, side, i, frame, frames.hands[side_index(side)]);
    }
  }
  return frames;
}

std::map<std::string, std::string> metadata_names(const fs::path& folder) {
  std::map<std::string, std::string> object_names;
  const fs::path file = folder / "metadata.json";
  if (!is_file(file)) return object_names;
  const nlohmann::json json = read_json(file);
  const JsonNode top{file.string(), 0, "", &json};
  if (!top.has("object_uids") || !top.has("object_names")) return object_names;
  const nlohmann::json& uids = *top.at("object_uids").value;
  const nlohmann::json& names = *top.at("object_names").value;
  for (std::size_t k = 0; k < std::min(uids.size(), names.size()); ++k) {
    if (uids[k].is_string() && names[k].is_string()) object_names[uids[k]] = names[k];
  }
  return object_names;
}

/// Returns the folders in which objects' meshes and names may be.
std::vector<fs::path> libraries(const fs::path& folder) {
  std::vector<fs::path> libraries{folder};
  for (const fs::path& above : {folder, folder / "..", folder / ".." / ".."}) {
    for (const char* name : {"object_models", "object_library", "assets"})
      libraries.push_back(above / name);
  }
  return libraries;
}

std::map<std::string, std::string> library_names(const fs::path& folder) {
  std::map<std::string, std::string> names;
  for (const fs::path& library : libraries(folder)) {
    const fs::path file = library / "instance.json";
    if (!is_file(file)) continue;
    const nlohmann::json json = read_json(file);
    for (const auto& [uid, entry] : json.items()) {
      const JsonNode object{file.string(), 0, uid, &entry};
      if (object.has("instance_name")) names.emplace(uid, object.at("instance_name").text());
    }
  }
  return names;
}

SceneObject shape_of(const fs::path& folder, const std::string& uid, const std::string& name,
                     std::vector<std::string>& reports) {
  for (const fs::path& library : libraries(folder)) {
    const fs::path file = library / (uid + ".glb");
    if (!is_file(file)) continue;
    SceneObject mesh;
    mesh.shape = Shape::mesh;
    const std::string fault = collision::load_mesh(file, 1, false, mesh);
    if (!fault.empty()) throw InputError(fmt::format("{}: {}", file.string(), fault));
    mesh.name = name;
    add_note(reports, "object {}: shape from {}", name, file.string());
    return mesh;
  }
  return placeholder_sphere(name, reports);
}

std::vector<SceneObject> read_objects(const fs::path& folder, const TrackerFrame& frame,
                                      std::int64_t begin_ns, std::vector<std::string>& reports) {
  std::vector<SceneObject> objects;
  const fs::path file = folder / "dynamic_objects.csv";
  if (!is_file(file)) {
    reports.push_back("no dynamic_objects.csv beside the file: no object was recorded");
    return objects;
  }
  std::map<std::string, std::string> names = metadata_names(folder);
  names.merge(library_names(folder));
  std::set<std::string> taken;
  for (const auto& [uid, poses] : read_hot3d_poses(file)) {
    std::string name = names.contains(uid) ? names[uid] : "object_" + uid;
    if (!taken.insert(name).second) taken.insert(name += "_" + uid);
    SceneObject object = shape_of(folder, uid, name, reports);
    std::int64_t last_ns = 0;
    for (std::size_t i = 0; i < poses.time_ns.size(); ++i) {
      if (i > 0 && poses.time_ns[i] - last_ns < kSameFrame_ns) continue;
      last_ns = poses.time_ns[i];
      const Pose pose = frame.pose(poses.pose[i]);
      object.time.push_back(seconds(begin_ns, last_ns));
      object.position.push_back(pose.translation());
      object.orientation.push_back(Quat(pose.linear()));
    }
    objects.push_back(std::move(object));
  }
  return objects;
}

/// Returns a body whose head has the headset's first pose within 10 ms of each frame of the hands.
BodyStream read_head(const fs::path& folder, const std::vector<std::int64_t>& time_ns,
                     const TrackerFrame& frame) {
  const fs::path file = folder / "headset_trajectory.csv";
  if (!is_file(file)) return {};
  const auto bodies = read_hot3d_poses(file);
  if (bodies.empty()) return {};
  const TimedPoses& headset = bodies.begin()->second;
  BodyStream body = unseen_body({"head"}, time_ns.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < time_ns.size(); ++i) {
    const std::int64_t min_ns = time_ns[i] - kSameFrame_ns, max_ns = time_ns[i] + kSameFrame_ns;
    while (next < headset.time_ns.size() && headset.time_ns[next] < min_ns) ++next;
    if (next == headset.time_ns.size() || headset.time_ns[next] > max_ns) continue;
    set_pose(frame.pose(headset.pose[next]), i, 0, body);
  }
  return body;
}

struct Metadata {
  std::string axes, axes_reason, subject;
};

Metadata read_metadata(const fs::path& folder, const RecordingFiles& files) {
  Metadata metadata;
  const fs::path file = folder / "metadata.json";
  std::string headset;
  if (is_file(file)) {
    const nlohmann::json json = read_json(file);
    const JsonNode top{file.string(), 0, "", &json};
    if (top.has("headset")) headset = top.at("headset").text();
    if (top.has("participant_id")) metadata.subject = top.at("participant_id").text();
  }
  if (headset == "Aria") {
    metadata.axes = "x y z";
  } else if (headset.starts_with("Quest")) {
    metadata.axes = "x -z y";
  } else if (files.conventions.axes.empty()) {
    throw UnresolvedConvention(
        "axes", fmt::format("{}: axes: no metadata.json beside the file names the headset (Aria "
                            "has Z up, Quest 3 Y); give --axes or `axes:`",
                            files.file.string()));
  }
  metadata.axes_reason =
      fmt::format("up axis of the headset {}; facing direction not in the file", headset);
  return metadata;
}

}  // namespace

bool recognises_hot3d(std::string_view head) {
  const std::string_view line = head.substr(0, head.find('\n'));
  const auto has = [&](std::string_view key) { return line.find(key) != std::string_view::npos; };
  return line.starts_with('{') && has("\"timestamp_ns\"") && has("\"hand_poses\"") &&
         head.find("\"betas\"") == std::string_view::npos;  // only in the file for MANO's model
}

Demonstration read_hot3d(const RecordingFiles& files) {
  const fs::path folder = files.file.parent_path();
  const fs::path profile = folder / "umetrack_hand_user_profile.json";
  if (!is_file(profile)) {
    throw InputError(fmt::format("{}: the hand model {} is missing beside it", files.file.string(),
                                 profile.filename().string()));
  }
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  const Metadata metadata = read_metadata(folder, files);
  demonstration.subject = metadata.subject;
  const TrackerFrame frame =
      tracker_frame(files, metadata.axes, "m", metadata.axes_reason, reports);
  HandFrames read = read_hands(files.file, read_umetrack_hand(profile), frame);
  if (read.duplicate_count > 0) {
    add_note(reports, "{} skipped, within 10 ms of the previous one: from another camera",
             count_with_noun(read.duplicate_count, "frame"));
  }
  HandClip clip;
  if (read.time_ns.empty()) throw InputError(fmt::format("{}: has no frames", files.file.string()));
  const std::int64_t begin_ns = read.time_ns.front();
  for (const std::int64_t now_ns : read.time_ns) clip.time.push_back(seconds(begin_ns, now_ns));
  add_note(reports, "time 0 is {} ns in the file", begin_ns);
  clip.hands = {std::move(read.hands[0]), std::move(read.hands[1])};
  clip.objects = read_objects(folder, frame, begin_ns, reports);
  clip.body = read_head(folder, read.time_ns, frame);
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
