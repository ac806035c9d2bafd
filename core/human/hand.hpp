#pragma once

#include <array>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::human {

/// The size of a human hand.
struct HandSize {
  double length = 0, breadth = 0;  ///< wrist to middle fingertip; across the knuckles [m]
};

/// Returns the hand size of an average adult: ANSUR II ratios to stature, the mean of women and
/// men.
HandSize hand_size_of_stature(double stature_m);

/// The angles kHandAngleNames of a hand [rad]: flexion (mcp, pip, dip, ip) bends towards the pad,
/// abduction tilts towards the thumb's side, thumb_rotation moves the thumb out of the palm's plane
/// into opposition; `palm_arch` lowers the little finger's metacarpal towards the palm, and the
/// ring finger's by 20/28 of it. Zero is the flat hand, with the thumb beside it in the palm's
/// plane.
struct HandAngles {
  std::array<double, kHandAngleCount> joint{};
  double palm_arch = 0;
};

/// Returns the human hand as a kinematic tree: lengths and bases of the digits by the ratios of
/// Buchholz et al. (1992) to hand length and breadth. Base: the hand frame of HumanMotion (origin
/// at the wrist, z to the fingers, y to the thumb's side, x out of the palm). Joints:
/// kHandAngleNames, then palm_arch, with their human limits; speeds are not limited. Tips: thumb …
/// little, on the finger's axis; z of a tip is along its distal bone, x out of the pad.
///
/// Fingers: abduction about -x, then flexions about y. Thumb, at its CMC joint: rotation about -z,
/// abduction about -x from 30 degrees beside z, then flexions of MCP and IP, which at zero rotation
/// bend it across the palm and at 90 degrees towards the pads of the fingers.
RobotModel human_hand(const HandSize& size);

/// The points of the hand in the hand frame.
struct HandPoints {
  std::array<Vec3, kFingerCount> tip;
  std::array<Quat, kFingerCount> tip_orientation;
  std::array<Vec3, kFingerCount> middle_joint;  ///< PIP, for the thumb MCP
};
/// Computes the points by forward kinematics; `frames` is a buffer that can be reused.
HandPoints hand_points(const RobotModel& hand, const HandAngles& angles, std::vector<Pose>& frames);

}  // namespace morphe::human
