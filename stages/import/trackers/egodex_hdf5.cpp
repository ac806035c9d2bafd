// An episode of EgoDex: HDF5 with a group `transforms` of 4 x 4 matrices (row by row) per frame,
// the joints of ARKit's body and hands and the camera in a world with Y up, in metres, at 30 frames
// per second; beside it `confidences` of the joints. It contains no objects.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/store/hdf5_file.hpp"
#include "core/store/sandbox_probe.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/apple_hand.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

using store::Hdf5Group;

constexpr double kEgodexRate_hz = 30;

/// The joints of ARKit, each at the proximal end of its bone, and Morphe's names of them.
constexpr std::pair<const char*, const char*> kEgodexJoints[] = {{"hip", "pelvis"},
                                                                 {"neck4", "neck"},
                                                                 {"camera", "head"},
                                                                 {"rightArm", "right_shoulder"},
                                                                 {"rightForearm", "right_elbow"},
                                                                 {"leftArm", "left_shoulder"},
                                                                 {"leftForearm", "left_elbow"}};

struct Track {
  std::vector<Pose> pose;
  std::vector<double> confidence;  ///< may be empty

  bool seen(std::size_t row) const { return confidence.empty() || confidence[row] > 0; }
};

struct Episode {
  Hdf5Group transforms, confidences;
  bool has_confidences = false;
  std::map<std::string, std::string> names;  ///< names in the file, by normalized_apple_name()
  std::size_t rows = 0;
};

Episode open_episode(const Hdf5Group& root) {
  Episode episode;
  episode.transforms = root.open("transforms");
  episode.has_confidences = root.has("confidences");
  if (episode.has_confidences) episode.confidences = root.open("confidences");
  for (const std::string& name : episode.transforms.children())
    episode.names[normalized_apple_name(name)] = name;
  for (const char* wrist : {"righthand", "lefthand"}) {
    const auto found = episode.names.find(wrist);
    if (found != episode.names.end()) episode.rows = episode.transforms.length(found->second);
  }
  if (episode.rows == 0) episode.transforms.fail("has neither rightHand nor leftHand");
  return episode;
}

/// Reads the poses of a joint over all frames; empty if the file does not have the joint.
Track read_track(const Episode& episode, const std::string& canonical_name) {
  Track track;
  const auto found = episode.names.find(canonical_name);
  if (found == episode.names.end()) return track;
  const std::string& name = found->second;
  const auto matrices = episode.transforms.read<double>(name, {episode.rows, 4, 4});
  for (std::size_t i = 0; i < episode.rows; ++i) {
    const auto begin = matrices.values.begin() + (16 * i);
    const auto pose = pose_from_matrix(std::vector<double>(begin, begin + 16), false);
    if (!pose) episode.transforms.fail(name, fmt::format("row {} is not a rigid transform", i));
    track.pose.push_back(*pose);
  }
  if (episode.has_confidences && episode.confidences.has(name)) {
    track.confidence = episode.confidences.read<double>(name, {episode.rows}).values;
    for (double& confidence : track.confidence) confidence = std::clamp(confidence, 0.0, 1.0);
  }
  return track;
}

RecordedHand read_hand(const Episode& episode, Side side, const TrackerFrame& frame) {
  RecordedHand hand = unseen_hand(episode.rows);
  for (int k = 0; k < kKeypointCount; ++k) {
    const std::string joint = k == 0 ? "hand" : apple_joints()[k];
    const Track track = read_track(episode, std::string(name_of(side)) + joint);
    for (std::size_t i = 0; i < track.pose.size(); ++i) {
      if (track.seen(i)) hand.keypoints(i, k) = frame.point(track.pose[i].translation());
    }
    if (k == 0) hand.confidence = track.confidence;
  }
  return hand;
}

BodyStream read_body(const Episode& episode, const TrackerFrame& frame) {
  std::vector<std::string> names;
  std::vector<Track> tracks;
  for (const auto& [in_file, name] : kEgodexJoints) {
    Track track = read_track(episode, normalized_apple_name(in_file));
    if (track.pose.empty()) continue;
    names.emplace_back(name);
    tracks.push_back(std::move(track));
  }
  BodyStream body = unseen_body(names, episode.rows);
  if (episode.has_confidences) body.confidence = {episode.rows, tracks.size(), kUnknown};
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    for (std::size_t i = 0; i < episode.rows; ++i) {
      if (!tracks[k].confidence.empty()) body.confidence(i, k) = tracks[k].confidence[i];
      if (tracks[k].seen(i)) set_pose(frame.pose(tracks[k].pose[i]), i, k, body);
    }
  }
  return body;
}

void report_descriptions(const Hdf5Group& root, std::vector<std::string>& reports) {
  for (const char* name : {"task", "object", "description", "llm_description", "session_name"}) {
    if (!root.has_attribute(name)) continue;
    const store::Hdf5Value value = root.value_of_attribute(name);
    if (value.is_text && !value.texts.empty() && !value.texts[0].empty())
      add_note(reports, "{}: {}", name, value.texts[0]);
  }
}

}  // namespace

bool recognises_egodex_hdf5(std::string_view head) {
  const auto has = [&](std::string_view word) { return head.find(word) != std::string_view::npos; };
  return head.starts_with("\x89HDF\r\n") && has("transforms") && has("camera") &&
         !has("morphe-demonstrations");
}

Demonstration read_egodex_hdf5(const RecordingFiles& files) {
  store::probe_in_sandbox(files.file);
  const store::Hdf5File file = store::Hdf5File::open(files.file);
  const Hdf5Group root = file.root();
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  const TrackerFrame frame = tracker_frame(files, "x -z y", "m", kAppleAxesReason, reports);
  const Episode episode = open_episode(root);
  const double rate_hz =
      resolve_rate_hz(kEgodexRate_hz, files.conventions, files.file.string(), reports);
  HandClip clip;
  for (std::size_t i = 0; i < episode.rows; ++i)
    clip.time.push_back(static_cast<double>(i) / rate_hz);
  for (const Side side : {Side::right, Side::left})
    clip.hands[side_index(side)] = read_hand(episode, side, frame);
  clip.body = read_body(episode, frame);
  file.expect_unchanged();
  reports.push_back("shoulders and elbows are estimated by the headset, mostly from the hands");
  report_descriptions(root, reports);
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
