// MVNX of Xsens: a body from inertial sensors as segments, each at its proximal joint and with its
// orientation; with gloves also the segments of the fingers. World: X forward, Y left, Z up,
// metres. It contains no objects.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/mvnx_file.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

struct NamedSegment {
  const char* label;
  const char* joint;
};
/// A segment begins at its proximal joint.
constexpr NamedSegment kMvnxJoints[] = {{"Pelvis", "pelvis"},
                                        {"T8", "trunk"},
                                        {"Head", "head"},
                                        {"RightUpperArm", "right_shoulder"},
                                        {"RightForeArm", "right_elbow"},
                                        {"LeftUpperArm", "left_shoulder"},
                                        {"LeftForeArm", "left_elbow"}};
constexpr const char* kFingerOrdinals[] = {"First", "Second", "Third", "Fourth", "Fifth"};

std::optional<std::size_t> find(const MvnxSegments& segments, const std::string& label) {
  const auto found = std::ranges::find(segments.labels, label);
  if (found == segments.labels.end()) return std::nullopt;
  return found - segments.labels.begin();
}

BodyStream body_of(const MvnxFile& mvnx, const TrackerFrame& frame) {
  BodyStream body;
  std::vector<std::size_t> columns;
  for (const NamedSegment& segment : kMvnxJoints) {
    const auto column = find(mvnx.body, segment.label);
    if (!column) continue;
    columns.push_back(*column);
    body.names.emplace_back(segment.joint);
  }
  const std::size_t rows = mvnx.time.size();
  body.position = Array2D<Vec3>(rows, columns.size(), unknown_point());
  body.orientation = Array2D<Quat>(rows, columns.size(), unknown_rotation());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      body.position(i, k) = frame.point(mvnx.body.position(i, columns[k]));
      body.orientation(i, k) = frame.rotation(mvnx.body.orientation(i, columns[k]));
    }
  }
  return body;
}

/// Returns the axes of the hand in its segment, which in the T-pose are those of the world: the
/// arms to the sides, palms down, thumbs forward. Fingers point along z, the thumb along y; x
/// points out of the palm of a right hand and out of the back of a left one, as in a mirror image.
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

/// Adds the keypoints at which the segments of a finger begin: MC at the thumb's first joint, PP,
/// MP, DP.
void add_fingers(const MvnxSegments& fingers, Side side, const TrackerFrame& frame,
                 RecordedHand& hand) {
  const std::string prefix = side == Side::right ? "Right" : "Left";
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const bool thumb = finger == kThumb;
    const std::vector<const char*> parts = thumb ? std::vector<const char*>{"MC", "PP", "DP"}
                                                 : std::vector<const char*>{"PP", "MP", "DP"};
    for (std::size_t part = 0; part < parts.size(); ++part) {
      const std::string label = prefix + kFingerOrdinals[finger] + parts[part];
      const auto column = find(fingers, label);
      if (!column) continue;
      const std::size_t keypoint = 1 + 4 * finger + part;
      const auto tip = fingers.tips.find(label);
      for (std::size_t i = 0; i < hand.keypoints.rows; ++i) {
        const Vec3& begin = fingers.position(i, *column);
        hand.keypoints(i, keypoint) = frame.point(begin);
        if (part == 2 && tip != fingers.tips.end()) {
          hand.keypoints(i, keypoint + 1) =
              frame.point(begin + fingers.orientation(i, *column) * tip->second);
        }
      }
    }
  }
}

}  // namespace

bool recognises_mvnx(std::string_view head) {
  const std::size_t at = head.find("<mvnx");
  return at != std::string_view::npos && head.find_first_not_of(" \t\r\n") == head.find('<');
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
    const auto which = static_cast<std::size_t>(side);
    const auto column = find(mvnx.body, side == Side::right ? "RightHand" : "LeftHand");
    if (!column) continue;
    RecordedHand hand = unseen_hand(clip.time.size());
    const Quat segment_from_hand(hand_axes(side));
    for (std::size_t i = 0; i < clip.time.size(); ++i) {
      hand.keypoints(i, 0) = frame.point(mvnx.body.position(i, *column));
      hand.orientation.push_back(frame.rotation(mvnx.body.orientation(i, *column)) *
                                 segment_from_hand);
    }
    const MvnxSegments& fingers = mvnx.fingers[which];
    add_fingers(fingers, side, frame, hand);
    if (fingers.labels.empty()) {
      reports.push_back(fmt::format("no glove on the {} hand: no fingers recorded", name_of(side)));
    } else if (fingers.tips.empty()) {
      reports.push_back(
          fmt::format("the file does not state the positions of the {} fingertips in "
                      "their segments",
                      name_of(side)));
    }
    clip.hands[which] = std::move(hand);
  }
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
