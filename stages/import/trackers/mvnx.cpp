// MVNX of Xsens: position (of the proximal joint) and orientation of the segments of a body, with
// gloves also of the fingers. World: X forward, Y left, Z up, metres. It contains no objects.
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/mvnx_file.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

/// The labels of segments and Morphe's names of the proximal joints at which they begin.
constexpr std::pair<const char*, const char*> kMvnxJoints[] = {{"Pelvis", "pelvis"},
                                                               {"T8", "trunk"},
                                                               {"Head", "head"},
                                                               {"RightUpperArm", "right_shoulder"},
                                                               {"RightForeArm", "right_elbow"},
                                                               {"LeftUpperArm", "left_shoulder"},
                                                               {"LeftForeArm", "left_elbow"}};
constexpr const char* kFingerOrdinals[] = {"First", "Second", "Third", "Fourth", "Fifth"};

BodyStream body_of(const MvnxFile& mvnx, const TrackerFrame& frame) {
  std::vector<std::string> names;
  std::vector<int> columns;
  for (const auto& [label, joint] : kMvnxJoints) {
    const int column = name_index(mvnx.body.labels, label);
    if (column < 0) continue;
    columns.push_back(column);
    names.emplace_back(joint);
  }
  BodyStream body = unseen_body(names, mvnx.time.size());
  for (std::size_t i = 0; i < mvnx.time.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      body.position(i, k) = frame.point(mvnx.body.position(i, columns[k]));
      body.orientation(i, k) = frame.rotation(mvnx.body.orientation(i, columns[k]));
    }
  }
  return body;
}

/// Returns segment_from_hand. The hand frame is that of HumanMotion: z to the fingers, y to the
/// thumb, x out of the palm of a right hand and out of the back of a left one. The segment's axes
/// are the file's (X forward, Y left) in the T-pose: arms to the sides, palms down, thumbs forward.
Eigen::Matrix3d hand_axes(Side side) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  Eigen::Matrix3d axes;
  if (side == Side::right) {
    axes << -z, x, -y;
  } else {
    axes << z, x, y;
  }
  return axes;
}

void add_fingers(const MvnxSegments& fingers, Side side, const TrackerFrame& frame,
                 RecordedHand& hand) {
  constexpr const char* kThumbParts[] = {"MC", "PP", "DP"};
  constexpr const char* kFingerParts[] = {"PP", "MP", "DP"};
  const std::string prefix = side == Side::right ? "Right" : "Left";
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (int part = 0; part < 3; ++part) {
      const std::string label =
          prefix + kFingerOrdinals[finger] + (finger == kThumb ? kThumbParts : kFingerParts)[part];
      const int column = name_index(fingers.labels, label);
      if (column < 0) continue;
      const std::size_t keypoint = 1 + 4 * finger + part;
      const auto tip = fingers.tips.find(label);
      for (std::size_t i = 0; i < hand.keypoints.rows; ++i) {
        const Vec3& begin = fingers.position(i, column);
        hand.keypoints(i, keypoint) = frame.point(begin);
        if (part == 2 && tip != fingers.tips.end()) {
          hand.keypoints(i, keypoint + 1) =
              frame.point(begin + fingers.orientation(i, column) * tip->second);
        }
      }
    }
  }
}

}  // namespace

bool recognises_mvnx(std::string_view head) {
  return head.find("<mvnx") != std::string_view::npos &&
         head.find_first_not_of(" \t\r\n") == head.find('<');
}

Demonstration read_mvnx(const RecordingFiles& files) {
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  const TrackerFrame frame = tracker_frame(
      files, "-y x z", "m", "MVNX standard: x forward at the calibration, y left, z up", reports);
  const MvnxFile mvnx = read_mvnx_file(files.file, files.conventions.rate_hz.value_or(0));
  reports.insert(reports.end(), mvnx.import_notes.begin(), mvnx.import_notes.end());
  demonstration.subject = mvnx.subject;
  HandClip clip;
  clip.time = mvnx.time;
  clip.body = body_of(mvnx, frame);
  for (const Side side : {Side::right, Side::left}) {
    const int column = name_index(mvnx.body.labels, side == Side::right ? "RightHand" : "LeftHand");
    if (column < 0) continue;
    RecordedHand& hand = clip.hands[side_index(side)].emplace(unseen_hand(clip.time.size()));
    const Quat segment_from_hand(hand_axes(side));
    for (std::size_t i = 0; i < clip.time.size(); ++i) {
      hand.keypoints(i, 0) = frame.point(mvnx.body.position(i, column));
      hand.orientation.push_back(frame.rotation(mvnx.body.orientation(i, column)) *
                                 segment_from_hand);
    }
    const MvnxSegments& fingers = mvnx.fingers[side_index(side)];
    add_fingers(fingers, side, frame, hand);
    if (fingers.labels.empty()) {
      add_note(reports, "no glove on the {} hand: no fingers recorded", name_of(side));
    } else if (fingers.tips.empty()) {
      add_note(reports,
               "the file does not state the positions of the {} fingertips in their segments",
               name_of(side));
    }
  }
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
