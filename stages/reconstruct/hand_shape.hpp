#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::reconstruct {

/// The wrist, then four points a finger from its base to its tip, thumb first (thumb: CMC, MCP, IP,
/// tip; fingers: MCP, PIP, DIP, tip).
inline constexpr std::size_t kHandKeypoints = 1 + 4 * kFingers;
using HandKeypoints = std::array<Vec3, kHandKeypoints>;
inline constexpr std::size_t keypoint_of(std::size_t finger, std::size_t joint) {
  return 1 + 4 * finger + joint;
}

/// Axes of the hand frame of HumanMotion from its geometry (a right hand): z along `to_fingers`, y
/// what is square to it of `to_thumb`, x = y × z. NaN if they are parallel or one is not seen.
Eigen::Matrix3d hand_axes(const Vec3& to_fingers, const Vec3& to_thumb);

/// Axes of a hand of which the points are seen: z from the wrist to the middle knuckle, y from the
/// little finger's knuckle to the index's.
Eigen::Matrix3d hand_axes(const HandKeypoints& points);

/// One person's hand: where its digits begin in the hand frame, and how long their bones are [m].
struct HandShape {
  std::array<Vec3, kFingers> base;                    ///< CMC of the thumb, knuckles
  std::array<std::array<double, 3>, kFingers> bones;  ///< from the base to the tip
  bool thumb_base_estimated = false;                  ///< no tracker's point: put_thumb_base
  double length() const;                              ///< wrist to middle fingertip, stretched
};

/// Medians over the frames in which the points are seen. The thumb's base, which some trackers do
/// not have, is estimated from the others where it never is seen; nothing if another point never
/// is.
std::optional<HandShape> median_hand(const std::vector<HandKeypoints>& frames);

/// Hand of these bones that points where recorded points do, in the hand frame (fit_palm): from the
/// base on, each bone has its length and the direction of the way between its points. (As near to
/// the points as the bones let it would fold a finger whose points are too close together.) Unseen
/// points, and those beyond them, stay unseen. Of a thumb whose base is an estimate the MCP is
/// where it was recorded, and the bones begin there.
HandKeypoints keep_bones(const HandShape& shape, const HandKeypoints& in_hand);

/// human_hand() with these bases and bones.
RobotTable hand_of_shape(const HandShape& shape);

/// Rotation R of the hand about its wrist that minimises sum |R base_k - (p_k - wrist)|^2 over the
/// four knuckles; NaN if one is not seen.
Eigen::Matrix3d fit_palm(const HandShape& shape, const HandKeypoints& points);

}  // namespace morphe::reconstruct
