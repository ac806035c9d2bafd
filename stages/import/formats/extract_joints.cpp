#include "stages/import/formats/extract_joints.hpp"

#include <algorithm>

#include "stages/import/recording/arm_names.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {
namespace {

Array2D<Vec3> columns_of(const Array2D<Vec3>& table, const std::vector<int>& columns) {
  Array2D<Vec3> selected(table.rows, columns.size(), unknown_point());
  for (std::size_t i = 0; i < selected.rows; ++i) {
    for (std::size_t k = 0; k < selected.cols; ++k) selected(i, k) = table(i, columns[k]);
  }
  return selected;
}

/// Returns false if the wrist or the centre of the hand stays in place, as in a frame of the hand.
bool moves_in_world(const HandStream& hand) {
  constexpr double kMinHandMotion_m = 0.05;
  Eigen::AlignedBox3d wrist, centre;
  for (std::size_t i = 0; i < hand.position.rows; ++i) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::size_t k = 0; k < hand.position.cols; ++k) {
      if (!is_known(hand.position(i, k))) continue;
      sum += hand.position(i, k);
      ++count;
    }
    if (count > 0) centre.extend(Vec3(sum / count));
    if (is_known(hand.position(i, 0))) wrist.extend(hand.position(i, 0));
  }
  return !wrist.isEmpty() &&
         std::min(wrist.diagonal().norm(), centre.diagonal().norm()) > kMinHandMotion_m;
}

}  // namespace

void extract_joints(Side hand, Demonstration& demonstration) {
  const MarkerStream& points = *demonstration.streams.markers;
  BodyStream joints;
  MarkerStream markers;
  std::vector<int> joint_columns, marker_columns;
  for (int k = 0; k < std::ssize(points.names); ++k) {
    const bool is_joint = is_joint_name(points.names[k]);
    (is_joint ? joints.names : markers.names).push_back(points.names[k]);
    (is_joint ? joint_columns : marker_columns).push_back(k);
  }
  if (joints.names.empty()) return;
  joints.time = markers.time = points.time;
  joints.position = columns_of(points.position, joint_columns);
  markers.position = columns_of(points.position, marker_columns);
  joints.orientation = Array2D<Quat>(points.time.size(), joints.names.size(), unknown_rotation());
  demonstration.streams.markers.reset();  // from here on, `points` does not exist
  if (!markers.names.empty()) demonstration.streams.markers = std::move(markers);

  std::vector<int> hand_columns;
  for (const std::string& name : keypoint_names(hand))
    hand_columns.push_back(name_index(joints.names, name));
  if (std::ranges::min(hand_columns) >= 0 && joints.names.size() == hand_columns.size()) {
    HandStream keypoints;
    keypoints.kind = HandKind::keypoints;
    keypoints.time = joints.time;
    keypoints.position = columns_of(joints.position, hand_columns);
    if (!moves_in_world(keypoints)) {
      demonstration.import_notes.push_back(
          "the points are of a hand that stays in place, without an arm; only its shape is used");
      demonstration.streams.hand = std::move(keypoints);
      return;
    }
  }
  joints.parents.assign(joints.names.size(), "");
  add_note(demonstration.import_notes, "{} points are used as joint centres, by their names",
           joints.names.size());
  demonstration.streams.skeleton = std::move(joints);
}

}  // namespace morphe::imports
