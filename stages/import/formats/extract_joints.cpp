#include "stages/import/formats/extract_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/motion/human_motion.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

void move_column(const MarkerStream& from, std::size_t k, std::vector<std::string>& names,
                 std::vector<Vec3>& columns) {
  names.push_back(from.names[k]);
  for (std::size_t i = 0; i < from.position.rows; ++i) columns.push_back(from.position(i, k));
}

/// Returns a table with the given columns.
Array2D<Vec3> table_of(const std::vector<Vec3>& columns, std::size_t rows, std::size_t cols) {
  Array2D<Vec3> table(rows, cols, unknown_point());
  for (std::size_t k = 0; k < cols; ++k) {
    for (std::size_t i = 0; i < rows; ++i) table(i, k) = columns[k * rows + i];
  }
  return table;
}

/// Returns the columns of the hand's points in the order of keypoints, if all exist.
std::optional<std::vector<std::size_t>> hand_columns(const std::vector<std::string>& names,
                                                     const std::string& side) {
  std::vector<std::size_t> columns;
  const auto find = [&](const std::string& part) {
    const auto found = std::ranges::find(names, side + "_" + part);
    if (found == names.end()) return false;
    columns.push_back(found - names.begin());
    return true;
  };
  bool whole = find("wrist");
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (const std::string& joint : finger_joint_names(finger)) whole = find(joint) && whole;
  }
  return whole ? std::optional(columns) : std::nullopt;
}

/// Returns true if the hand moves. In a frame of its own, the wrist or the centre of the hand is at
/// rest.
bool moves_in_world(const HandStream& hand) {
  constexpr double kMinHandMotion_m = 0.05;
  Eigen::AlignedBox3d wrist, middle;
  for (std::size_t i = 0; i < hand.position.rows; ++i) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::size_t k = 0; k < hand.position.cols; ++k) {
      if (!is_known(hand.position(i, k))) continue;
      sum += hand.position(i, k);
      ++count;
    }
    if (count > 0) middle.extend(Vec3(sum / count));
    if (is_known(hand.position(i, 0))) wrist.extend(hand.position(i, 0));
  }
  return !wrist.isEmpty() &&
         std::min(wrist.diagonal().norm(), middle.diagonal().norm()) > kMinHandMotion_m;
}

}  // namespace

void extract_joints(Side hand, Demonstration& demonstration) {
  MarkerStream& points = *demonstration.streams.markers;
  BodyStream joints;
  MarkerStream rest;
  std::vector<Vec3> of_joints, of_rest;
  for (std::size_t k = 0; k < points.names.size(); ++k) {
    if (is_joint_name(points.names[k])) {
      move_column(points, k, joints.names, of_joints);
    } else {
      move_column(points, k, rest.names, of_rest);
    }
  }
  if (joints.names.empty()) return;
  const std::size_t rows = points.time.size();
  joints.time = rest.time = points.time;
  joints.position = table_of(of_joints, rows, joints.names.size());
  rest.position = table_of(of_rest, rows, rest.names.size());
  demonstration.streams.markers.reset();
  if (!rest.names.empty()) demonstration.streams.markers = std::move(rest);

  const std::string side(name_of(hand));
  const auto has = [&](const char* part) {
    return std::ranges::find(joints.names, side + "_" + part) != joints.names.end();
  };
  const auto columns = hand_columns(joints.names, side);
  if (columns && !has("shoulder") && !has("elbow") && joints.names.size() == columns->size()) {
    HandStream keypoints;
    keypoints.kind = HandKind::keypoints;
    keypoints.time = joints.time;
    keypoints.position = Array2D<Vec3>(rows, columns->size(), unknown_point());
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < columns->size(); ++k) {
        keypoints.position(i, k) = joints.position(i, (*columns)[k]);
      }
    }
    if (!moves_in_world(keypoints)) {
      demonstration.import_notes.push_back(
          "the points are of a hand that stays in place, without an arm; only its shape is used "
          "them");
      demonstration.streams.hand = std::move(keypoints);
      return;
    }
  }
  joints.parents.assign(joints.names.size(), "");
  joints.orientation = Array2D<Quat>(rows, joints.names.size(), unknown_rotation());
  demonstration.import_notes.push_back(
      fmt::format("{} points are used as joint centres, by their names", joints.names.size()));
  demonstration.streams.skeleton = std::move(joints);
}

}  // namespace morphe::imports
