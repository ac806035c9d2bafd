#include "stages/import/clips/clip_hand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "stages/import/clips/joint_order.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

constexpr double kSameWrist_m = 0.005;

/// Returns [rows, J] joints in the world, in the order of the file.
Array2D<Vec3> joints_in(const files::NpyArray& array, const TrackerFrame& frame) {
  Array2D<Vec3> joints(array.shape[0], array.shape[1], unknown_point());
  for (std::size_t k = 0; k < joints.values.size(); ++k)
    joints.values[k] = frame.point(Eigen::Map<const Vec3>(array.values.data() + 3 * k));
  return joints;
}

JointOrder order_of(ClipArrays& clip, const std::string& key, const Array2D<Vec3>& joints,
                    const std::string& prefix, const Conventions& conventions,
                    std::vector<std::string>& reports) {
  const std::vector<std::string> names = clip.texts(prefix + "joint_names");
  const std::string in_file = clip.text("joint_order").value_or("");
  if (names.empty() || !conventions.joint_order.empty())
    return joint_order_of(joints, in_file, conventions, clip.file(), key);
  if (names.size() != joints.cols) {
    clip.fail(prefix + "joint_names",
              fmt::format("has {} names, but {} has {} joints", names.size(), key, joints.cols));
  }
  std::vector<std::string> unknown;
  JointOrder order = order_by_names(names, unknown);
  if (unknown.size() == names.size())
    clip.fail(prefix + "joint_names", "has no name of a hand joint, such as index_tip");
  if (!unknown.empty())
    add_note(reports, "{}: joints skipped, names unknown: {}", key, fmt::join(unknown, ", "));
  if (conventions.plausibility_checks) expect_hand_in_order(joints, order, clip.file(), key);
  return order;
}

void fill_wrist(const std::vector<Vec3>& wrist, Side side, RecordedHand& hand,
                std::vector<std::string>& reports) {
  int differing_count = 0;
  for (std::size_t i = 0; i < wrist.size(); ++i) {
    Vec3& joint = hand.keypoints(i, 0);
    if (!is_known(joint)) {
      joint = wrist[i];
    } else if ((joint - wrist[i]).norm() > kSameWrist_m) {
      ++differing_count;
    }
  }
  if (differing_count > 0) {
    add_note(reports, "the {} wrist_pos and the wrist joint differ in {} frames; the joint is used",
             name_of(side), differing_count);
  }
}

bool determines_orientation(const RecordedHand& hand) {
  const Array2D<Vec3>& joints = hand.keypoints;
  for (std::size_t i = 0; i < joints.rows; ++i) {
    if (is_known(joints(i, 0)) && is_known(joints(i, 5)) && is_known(joints(i, 17))) return true;
  }
  return false;
}

void read_wrist_rotation(ClipArrays& clip, const std::string& key, Side side, std::size_t rows,
                         const TrackerFrame& frame, bool reconstructed, RecordedHand& hand,
                         std::vector<std::string>& reports) {
  const files::NpyArray* const array = clip.numbers(key, {rows, 3, 3});
  if (array == nullptr) return;
  const Quat wrist_from_hand(clip_wrist_from_hand(side));
  std::vector<Quat> orientation;
  for (std::size_t i = 0; i < rows; ++i) {
    const Quat wrist = clip_rotation(clip, *array, i);
    orientation.push_back(is_known(wrist) ? Quat(frame.rotation(wrist) * wrist_from_hand) : wrist);
  }
  if (!reconstructed && determines_orientation(hand)) return;
  hand.orientation = std::move(orientation);
  if (reconstructed) return;
  add_note(reports,
           "{}: used for the orientation of the hand, as no knuckles were recorded: its x points "
           "to the fingers, its z out of the back of the hand",
           key);
}

}  // namespace

std::string clip_prefix(Side side) { return fmt::format("mano_{}_", name_of(side)); }

Eigen::Matrix3d clip_wrist_from_hand(Side side) {
  // The hand frame of a left hand is a mirror image: its y, to the thumb, is -y of the wrist, and
  // its x points out of the back of the hand.
  const double sign = side == Side::right ? 1 : -1;
  Eigen::Matrix3d hand_axes;
  hand_axes << -sign * Vec3::UnitZ(), sign * Vec3::UnitY(), Vec3::UnitX();
  return hand_axes;
}

std::optional<RecordedHand> read_clip_hand(ClipArrays& clip, Side side, std::size_t rows,
                                           const TrackerFrame& frame, bool reconstructed,
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
    add_note(reports, "{}: {}", key, order.because);
    for (int k = 0; k < kKeypointCount; ++k) {
      if (order.joint[k] < 0) continue;
      for (std::size_t i = 0; i < rows; ++i) hand.keypoints(i, k) = joints(i, order.joint[k]);
    }
  }
  fill_wrist(wrist, side, hand, reports);
  read_wrist_rotation(clip, prefix + "wrist_rot", side, rows, frame, reconstructed, hand, reports);
  if (const auto* const confidence = clip.numbers(prefix + "confidence", {rows}))
    hand.confidence = confidence->values;
  return hand;
}

}  // namespace morphe::imports
