#include "stages/import/clips/clip_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/clips/joint_order.hpp"

namespace morphe::imports {
namespace {

constexpr double kSameWrist_m = 0.005;

/// Returns [rows, J] joints in the world, in the order of the file.
Array2D<Vec3> joints_in(const files::NpyArray& array, const TrackerFrame& frame) {
  Array2D<Vec3> joints(array.shape[0], array.shape[1], unknown_point());
  for (std::size_t k = 0; k < joints.values.size(); ++k) {
    joints.values[k] = frame.point(Eigen::Map<const Vec3>(array.values.data() + 3 * k));
  }
  return joints;
}

JointOrder order_of(ClipArrays& clip, const std::string& key, const Array2D<Vec3>& joints,
                    const std::string& prefix, const Conventions& conventions,
                    std::vector<std::string>& reports) {
  const std::vector<std::string> names = clip.texts(prefix + "joint_names");
  const std::string in_file = clip.text("joint_order").value_or("");
  if (names.empty() || !conventions.joint_order.empty()) {
    return joint_order_of(joints, in_file, conventions, clip.file(), key);
  }
  if (names.size() != joints.cols) {
    clip.fail(prefix + "joint_names",
              fmt::format("has {} names, but {} has {} joints", names.size(), key, joints.cols));
  }
  std::vector<std::string> unknown;
  JointOrder order = order_by_names(names, unknown);
  if (unknown.size() == names.size()) {
    clip.fail(prefix + "joint_names", "has no name of a hand joint, such as index_tip");
  }
  if (!unknown.empty()) {
    reports.push_back(
        fmt::format("{}: joints skipped, names unknown: {}", key, fmt::join(unknown, ", ")));
  }
  return order;
}

void fill_wrist(const std::vector<Vec3>& wrist, const std::string& side, RecordedHand& hand,
                std::vector<std::string>& reports) {
  std::size_t differ = 0;
  for (std::size_t i = 0; i < wrist.size(); ++i) {
    Vec3& here = hand.keypoints(i, 0);
    if (!is_known(here)) {
      here = wrist[i];
    } else if ((here - wrist[i]).norm() > kSameWrist_m) {
      ++differ;
    }
  }
  if (differ > 0) {
    reports.push_back(
        fmt::format("the {} wrist_pos and the wrist joint differ in {} frames; the joint is used",
                    side, differ));
  }
}

bool determines_orientation(const RecordedHand& hand) {
  for (std::size_t i = 0; i < hand.keypoints.rows; ++i) {
    if (is_known(hand.keypoints(i, 0)) && is_known(hand.keypoints(i, 5)) &&
        is_known(hand.keypoints(i, 17)))
      return true;
  }
  return false;
}

void read_wrist_rotation(ClipArrays& clip, const std::string& key, Side side, std::size_t rows,
                         const TrackerFrame& frame, bool rebuilt, RecordedHand& hand,
                         std::vector<std::string>& reports) {
  const files::NpyArray* const array = clip.numbers(key, {rows, 3, 3});
  if (array == nullptr) return;
  const Quat wrist_from_hand(clip_wrist_from_hand(side));
  std::vector<Quat> turned;
  for (std::size_t i = 0; i < rows; ++i) {
    const Quat turn = clip_rotation(clip, *array, i);
    turned.push_back(is_known(turn) ? Quat(frame.rotation(turn) * wrist_from_hand) : turn);
  }
  if (rebuilt) {
    hand.orientation = std::move(turned);
  } else if (!determines_orientation(hand)) {
    hand.orientation = std::move(turned);
    reports.push_back(
        fmt::format("{}: used for the orientation of the hand, as no knuckles were recorded: its x "
                    "points to the fingers, its z out of the back of the hand",
                    key));
  }
}

}  // namespace

std::string clip_prefix(Side side) { return fmt::format("mano_{}_", name_of(side)); }

Eigen::Matrix3d clip_wrist_from_hand(Side side) {
  // The columns are x, y and z of the hand frame in the wrist's. A left hand's thumb is on its -y,
  // and x of its hand frame, the mirror image of a right one's, points out of the back.
  const double sign = side == Side::right ? 1 : -1;
  Eigen::Matrix3d turn;
  turn.col(0) = -sign * Vec3::UnitZ();
  turn.col(1) = sign * Vec3::UnitY();
  turn.col(2) = Vec3::UnitX();
  return turn;
}

std::optional<RecordedHand> read_clip_hand(ClipArrays& clip, Side side, std::size_t rows,
                                           const TrackerFrame& frame, bool rebuilt,
                                           const Conventions& conventions,
                                           std::vector<std::string>& reports) {
  const std::string prefix = clip_prefix(side), key = prefix + "joints";
  std::vector<Vec3> wrist = clip.points(prefix + "wrist_pos", rows);
  for (Vec3& point : wrist) point = frame.point(point);
  const files::NpyArray* const array = clip.numbers(key, {rows, ClipArrays::kAnyLength, 3});
  if (array == nullptr && wrist.empty()) return std::nullopt;
  RecordedHand hand = unseen_hand(rows);
  if (array != nullptr) {
    const Array2D<Vec3> joints = joints_in(*array, frame);
    const JointOrder order = order_of(clip, key, joints, prefix, conventions, reports);
    reports.push_back(fmt::format("{}: {}", key, order.because));
    for (std::size_t k = 0; k < kKeypointCount; ++k) {
      if (order.joint[k] < 0) continue;
      for (std::size_t i = 0; i < rows; ++i) {
        hand.keypoints(i, k) = joints(i, order.joint[k]);
      }
    }
  }
  fill_wrist(wrist, std::string(name_of(side)), hand, reports);
  read_wrist_rotation(clip, prefix + "wrist_rot", side, rows, frame, rebuilt, hand, reports);
  if (const auto* const confidence = clip.numbers(prefix + "confidence", {rows})) {
    hand.confidence = confidence->values;
  }
  return hand;
}

}  // namespace morphe::imports
