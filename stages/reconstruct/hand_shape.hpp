#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::reconstruct {

/// Number of hand keypoints: the wrist, then four points per finger from base to tip, the thumb's
/// first (thumb: CMC, MCP, IP, tip; fingers: MCP, PIP, DIP, tip).
inline constexpr std::size_t kHandKeypoints = 1 + 4 * kFingerCount;
using HandKeypoints = std::array<Vec3, kHandKeypoints>;
/// Returns the index of a finger's keypoint.
inline constexpr std::size_t keypoint_index(std::size_t finger, std::size_t joint) {
  return 1 + 4 * finger + joint;
}

/// Returns the axes of HumanMotion's hand frame (a right hand): z along `to_fingers`, y the
/// component of `to_thumb` orthogonal to z, x = y × z. NaN if they are parallel or one is not seen.
Eigen::Matrix3d hand_axes(const Vec3& to_fingers, const Vec3& to_thumb);

/// The shape of a person's hand [m].
struct HandShape {
  std::array<Vec3, kFingerCount> base;  ///< CMC of the thumb, knuckles of the fingers, in the hand
  std::array<std::array<double, 3>, kFingerCount> bone_lengths;  ///< from the base to the tip
  bool thumb_base_estimated = false;  ///< true if the tracker has no such point
  double length() const;              ///< from wrist to stretched middle fingertip
};

/// Estimates a hand's shape by medians over the frames in which the points are seen. The thumb's
/// base, which some trackers do not provide, is estimated from the other points if it is never
/// seen. Returns nullopt if another point is never seen.
std::optional<HandShape> estimate_hand_shape(const std::vector<HandKeypoints>& frames);

/// Returns the keypoints of a hand with these bone lengths; `in_hand` and result are in the hand
/// frame (fit_palm). From the base on, each bone has the recorded direction between its points.
/// (The hand nearest to points that are too close together would fold its fingers.) Unseen points,
/// and those beyond them, stay unseen. If the thumb's base is an estimate, its bones start at the
/// recorded MCP.
HandKeypoints enforce_finger_lengths(const HandShape& shape, const HandKeypoints& in_hand);

/// Returns human_hand() with the bases and bone lengths of a shape.
RobotModel make_hand_model(const HandShape& shape);

/// Returns the rotation R of the hand about its wrist that minimises, over the four knuckles,
/// sum |R base_k - (p_k - wrist)|²; NaN if one is not seen.
Eigen::Matrix3d fit_palm(const HandShape& shape, const HandKeypoints& points);

}  // namespace morphe::reconstruct
