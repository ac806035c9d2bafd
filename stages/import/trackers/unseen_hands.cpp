#include "stages/import/trackers/unseen_hands.hpp"

#include <algorithm>
#include <span>

#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

/// Joints are at one point if they are nearer than this [m]: far less than a bone, and more than
/// the rounding of a file.
constexpr double kSamePoint_m = 1e-6;

std::span<Vec3> row_of(Array2D<Vec3>& points, std::size_t row) {
  return std::span(points.values).subspan(row * points.cols, points.cols);
}

/// Returns true if at least two joints are known, and all of them are at one point.
bool is_collapsed(std::span<const Vec3> joints) {
  const Vec3* first = nullptr;
  int known_count = 0;
  for (const Vec3& joint : joints) {
    if (!is_known(joint)) continue;
    ++known_count;
    if (first == nullptr) first = &joint;
    if ((joint - *first).norm() > kSamePoint_m) return false;
  }
  return known_count >= 2;
}

/// Hides the hand in frames in which its fingers are at one point. A wrist elsewhere stays.
int hide_collapsed_frames(Array2D<Vec3>& joints) {
  int hidden_count = 0;
  for (std::size_t i = 0; i < joints.rows; ++i) {
    const std::span<Vec3> hand = row_of(joints, i), fingers = hand.subspan(1);
    if (!is_collapsed(fingers)) continue;
    std::ranges::fill(is_collapsed(hand) ? hand : fingers, unknown_point());
    ++hidden_count;
  }
  return hidden_count;
}

/// Returns true if the column is known and exactly zero in some frame, and in others elsewhere.
bool leaves_origin(const Array2D<Vec3>& points, std::size_t column) {
  bool at_origin = false, elsewhere = false;
  for (std::size_t i = 0; i < points.rows; ++i) {
    const Vec3& point = points(i, column);
    if (!is_known(point)) continue;
    at_origin = at_origin || point.isZero(0);
    elsewhere = elsewhere || !point.isZero(0);
  }
  return at_origin && elsewhere;
}

int hide_visits_of_origin(Array2D<Vec3>& points) {
  int hidden_count = 0;
  for (std::size_t k = 0; k < points.cols; ++k) {
    if (!leaves_origin(points, k)) continue;
    for (std::size_t i = 0; i < points.rows; ++i) {
      if (!points(i, k).isZero(0)) continue;
      points(i, k) = unknown_point();
      ++hidden_count;
    }
  }
  return hidden_count;
}

void report_origin(int count, const std::string& whose, std::vector<std::string>& reports) {
  if (count == 0) return;
  add_note(reports, "{} points of the {} are exactly at the origin; treated as not visible", count,
           whose);
}

}  // namespace

void hide_unseen_points(const std::string& whose, Array2D<Vec3>& keypoints,
                        std::vector<std::string>& reports) {
  if (const int frames = hide_collapsed_frames(keypoints); frames > 0) {
    add_note(reports, "all joints of the {} are at one point in {} frames; treated as not visible",
             whose, frames);
  }
  report_origin(hide_visits_of_origin(keypoints), whose, reports);
}

void hide_unseen_points(HandClip& clip, std::vector<std::string>& reports) {
  for (const Side side : {Side::right, Side::left}) {
    auto& hand = clip.hands[side_index(side)];
    if (hand) hide_unseen_points(std::string(name_of(side)) + " hand", hand->keypoints, reports);
  }
  report_origin(hide_visits_of_origin(clip.body.position), "body", reports);
}

bool is_wrist_at_origin(const RecordedHand& hand) {
  bool wrist_seen = false, others_elsewhere = false;
  for (std::size_t i = 0; i < hand.keypoints.rows; ++i) {
    const Vec3& wrist = hand.keypoints(i, 0);
    if (is_known(wrist) && !wrist.isZero(kSamePoint_m)) return false;
    wrist_seen = wrist_seen || is_known(wrist);
    for (std::size_t k = 1; k < hand.keypoints.cols; ++k) {
      const Vec3& joint = hand.keypoints(i, k);
      others_elsewhere = others_elsewhere || (is_known(joint) && !joint.isZero(kSamePoint_m));
    }
  }
  return wrist_seen && others_elsewhere;
}

}  // namespace morphe::imports
