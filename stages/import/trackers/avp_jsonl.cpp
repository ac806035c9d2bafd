// tracking.jsonl of the recorder for Apple Vision Pro: a line per frame with `timestamp` [s], the
// head's matrix and the joints of both hands, each a 4 x 4 matrix column by column. The wrist is in
// ARKit's world (Y up), the other joints in the wrist's frame. A hand that was not seen is missing.
#include <map>

#include "stages/import/recording/json_lines.hpp"
#include "stages/import/trackers/apple_hand.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

struct AvpFrame {
  std::array<std::map<std::string, Pose>, 2> hands;  ///< by Side and canonical name
  std::optional<Pose> head;
};

Pose pose_of(const JsonNode& node) {
  const auto pose = pose_from_matrix(node.numbers(16), true);
  if (!pose) node.fail("is not a rigid transform in column-major order");
  return *pose;
}

AvpFrame read_frame(const JsonNode& line) {
  AvpFrame frame;
  if (line.has("headMatrix") && !line.at("headMatrix").value->is_null())
    frame.head = pose_of(line.at("headMatrix"));
  for (const auto& [key, side] :
       {std::pair("rightHand", Side::right), std::pair("leftHand", Side::left)}) {
    if (!line.has(key) || line.at(key).value->is_null()) continue;
    const JsonNode hand = line.at(key);
    if (!hand.value->is_object()) hand.fail("must be an object of joints");
    for (const auto& [name, value] : hand.value->items()) {
      if (value.is_null()) continue;
      const JsonNode joint = hand.at(name);
      frame.hands[side_index(side)][normalized_apple_name(name)] = pose_of(joint);
    }
  }
  return frame;
}

void set_keypoints(const std::map<std::string, Pose>& joints, const TrackerFrame& frame,
                   std::size_t row, RecordedHand& hand) {
  const auto wrist = joints.find("wrist");
  if (wrist == joints.end()) return;
  hand.keypoints(row, 0) = frame.point(wrist->second.translation());
  for (int k = 1; k < kKeypointCount; ++k) {
    const auto joint = joints.find(apple_joints()[k]);
    if (joint == joints.end()) continue;
    hand.keypoints(row, k) = frame.point(wrist->second * joint->second.translation());
  }
}

BodyStream head_of(const std::vector<AvpFrame>& frames, const TrackerFrame& frame) {
  BodyStream body = unseen_body({"head"}, frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].head) set_pose(frame.pose(*frames[i].head), i, 0, body);
  }
  return body;
}

}  // namespace

bool recognises_avp_jsonl(std::string_view head) {
  const std::string_view line = head.substr(0, head.find('\n'));
  const auto has = [&](std::string_view key) { return line.find(key) != std::string_view::npos; };
  return line.starts_with('{') && has("\"timestamp\"") &&
         (has("\"headMatrix\"") || has("\"leftHand\"") || has("\"rightHand\""));
}

Demonstration read_avp_jsonl(const RecordingFiles& files) {
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  const TrackerFrame frame = tracker_frame(files, "x -z y", "m", kAppleAxesReason, reports);
  HandClip clip;
  std::vector<AvpFrame> frames;
  bool forearm = false;
  each_json_line(files.file, [&](const JsonNode& line) {
    add_time(line.at("timestamp").number(), line.file, line.line, "timestamp", clip.time);
    frames.push_back(read_frame(line));
    for (const auto& hand : frames.back().hands) forearm = forearm || hand.contains("forearmarm");
  });
  for (int side = 0; side < 2; ++side) {
    RecordedHand& hand = clip.hands[side].emplace(unseen_hand(frames.size()));
    for (std::size_t i = 0; i < frames.size(); ++i)
      set_keypoints(frames[i].hands[side], frame, i, hand);
  }
  clip.body = head_of(frames, frame);
  if (forearm) reports.push_back("joints of the forearm skipped: only estimated by the device");
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
