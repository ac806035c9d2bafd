// Data saved from avp_stream, the library that streams hands from Apple Vision Pro: a .npz with
// `stream_right_wrist` [T, 1, 4, 4] in the world (which the library has already turned to Z up),
// `stream_right_fingers` [T, 25 or 27, 4, 4] in the wrist's frame, the same for the left hand, and
// `stream_head`. It contains no times.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "core/files/npz_file.hpp"
#include "stages/import/recording/conventions.hpp"
#include "stages/import/trackers/apple_hand.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

constexpr int kMatrixValueCount = 16;

/// The matrices of the joints in all frames; without joints if the file does not have the key.
struct MatrixTable {
  const files::NpyArray* array = nullptr;
  std::size_t rows = 0, joints = 0;
};

MatrixTable matrices_in(const files::NpzFile& npz, const std::string& key) {
  MatrixTable table{npz.find(key), 0, 0};
  if (table.array == nullptr) return table;
  const std::vector<std::size_t>& shape = table.array->shape;
  const std::size_t rank = shape.size();
  if (table.array->kind == files::NpyKind::text || !(rank == 3 || rank == 4) ||
      shape[rank - 1] != 4 || shape[rank - 2] != 4) {
    npz.fail(key, fmt::format("must have 4 x 4 matrices, not {}", files::shape_text(shape)));
  }
  table.rows = shape[0];
  table.joints = rank == 3 ? 1 : shape[1];
  return table;
}

/// Returns a joint's pose; no value for a matrix with a NaN or of zeros. Throws if it is not rigid.
std::optional<Pose> pose_in(const files::NpzFile& npz, const MatrixTable& table, std::size_t row,
                            std::size_t joint) {
  const auto begin =
      table.array->values.begin() + (kMatrixValueCount * (row * table.joints + joint));
  const std::vector<double> numbers(begin, begin + kMatrixValueCount);
  if (std::ranges::any_of(numbers, [](double v) { return std::isnan(v); }) ||
      std::ranges::all_of(numbers, [](double v) { return v == 0; })) {
    return std::nullopt;
  }
  const auto pose = pose_from_matrix(numbers, false);
  if (!pose) {
    npz.fail(table.array->name,
             fmt::format("row {}, joint {}: is not a rigid transform", row, joint));
  }
  return pose;
}

/// Returns true for no value and for the identity, which stands for a hand not detected yet.
bool is_unset_pose(const std::optional<Pose>& pose) {
  return !pose || pose->matrix().isApprox(Eigen::Matrix4d::Identity());
}

struct HandMatrices {
  MatrixTable wrist, fingers;
};

RecordedHand read_hand(const files::NpzFile& npz, const HandMatrices& matrices, std::size_t rows,
                       const TrackerFrame& frame) {
  RecordedHand hand = unseen_hand(rows);
  const KeypointOrder& order = *keypoint_order(matrices.fingers.joints == 27 ? "arkit" : "webxr");
  for (std::size_t i = 0; i < rows; ++i) {
    const auto wrist = pose_in(npz, matrices.wrist, i, 0);
    if (is_unset_pose(wrist)) continue;
    hand.keypoints(i, 0) = frame.point(wrist->translation());
    for (int k = 1; k < kKeypointCount && matrices.fingers.joints > 0; ++k) {
      const auto joint = pose_in(npz, matrices.fingers, i, order.joint[k]);
      if (joint) hand.keypoints(i, k) = frame.point(*wrist * joint->translation());
    }
  }
  return hand;
}

BodyStream read_head(const files::NpzFile& npz, std::size_t rows, const TrackerFrame& frame) {
  const MatrixTable table = matrices_in(npz, "stream_head");
  if (table.rows != rows || table.joints != 1) return {};
  BodyStream body = unseen_body({"head"}, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto head = pose_in(npz, table, i, 0);
    if (!is_unset_pose(head)) set_pose(frame.pose(*head), i, 0, body);
  }
  return body;
}

HandMatrices hand_matrices(const files::NpzFile& npz, Side side) {
  const std::string prefix = "stream_" + std::string(name_of(side));
  HandMatrices hand{matrices_in(npz, prefix + "_wrist"), matrices_in(npz, prefix + "_fingers")};
  if (hand.wrist.array == nullptr) return hand;
  if (hand.wrist.joints != 1) npz.fail(prefix + "_wrist", "must have one matrix per frame");
  if (hand.fingers.array == nullptr) npz.fail(prefix + "_fingers", "is missing");
  if (hand.fingers.rows != hand.wrist.rows) {
    npz.fail(prefix + "_fingers", fmt::format("has {} frames, but {}_wrist has {}",
                                              hand.fingers.rows, prefix, hand.wrist.rows));
  }
  if (hand.fingers.joints != 25 && hand.fingers.joints != 27) {
    npz.fail(prefix + "_fingers",
             fmt::format("must have 25 or 27 joints, not {}", hand.fingers.joints));
  }
  return hand;
}

}  // namespace

bool recognises_avp_npz(std::string_view head) {
  if (!files::is_npz(head)) return false;
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{"stream_right_", "stream_left_", "stream_head"},
      [&](std::string_view key) { return head.find(key) != std::string_view::npos; });
}

Demonstration read_avp_npz(const RecordingFiles& files) {
  const files::NpzFile npz = files::read_npz(files.file);
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  const TrackerFrame frame =
      tracker_frame(files, "x y z", "m",
                    "Z is up, as written by avp_stream; facing direction not in the file", reports);
  const double rate_hz = resolve_rate_hz(0, files.conventions, files.file.string(), reports);
  const HandMatrices hands[] = {hand_matrices(npz, Side::right), hand_matrices(npz, Side::left)};
  const std::size_t rows = std::max(hands[0].wrist.rows, hands[1].wrist.rows);
  if (rows == 0) npz.fail("stream_right_wrist", "neither this nor stream_left_wrist has frames");
  HandClip clip;
  for (std::size_t i = 0; i < rows; ++i) clip.time.push_back(static_cast<double>(i) / rate_hz);
  for (int side = 0; side < 2; ++side) {
    const MatrixTable& wrist = hands[side].wrist;
    if (wrist.array == nullptr) continue;
    if (wrist.rows != rows) npz.fail(wrist.array->name, "has fewer frames than the other hand");
    clip.hands[side] = read_hand(npz, hands[side], rows, frame);
  }
  clip.body = read_head(npz, rows, frame);
  add_tracked_clip(std::move(clip), files, demonstration);
  return demonstration;
}

}  // namespace morphe::imports
