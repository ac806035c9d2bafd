#pragma once

#include <array>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::human {

struct HandSize {
  double length = 0, breadth = 0;  ///< wrist to middle fingertip; across the knuckles [m]
};

/// Hand of an average adult: ANSUR II ratios to stature, the mean of women and men.
HandSize hand_size_of_stature(double stature_m);

/// kHandAngleNames [rad]: flexion (mcp, pip, dip, ip) curls towards the pad, abduction tilts
/// towards the thumb's side, thumb_rotation swings the thumb out of the palm's plane into
/// opposition; `palm_arch` lowers the little finger's metacarpal towards the palm, and the ring's
/// by 20/28 of it. Zero is the flat hand, the thumb beside it in the palm's plane.
struct HandAngles {
  std::array<double, kHandAngles> joint{};
  double palm_arch = 0;
};

/// The human hand as a kinematic tree: digit lengths and bases by the ratios of Buchholz et al.
/// (1992) to hand length and breadth. Base: the hand frame of HumanMotion (origin at the wrist, z
/// to the fingers, y to the thumb's side, x out of the palm). Joints: kHandAngleNames, then
/// palm_arch, with their human limits; speeds are not limited. Tips: thumb … little, on the
/// finger's axis; z of a tip points along its distal bone, x out of the pad.
///
/// Fingers: abduction about -x, then flexions about y. Thumb, at its CMC joint: rotation about -z,
/// abduction about -x from 30 degrees beside z, then flexions of MCP and IP, which at zero rotation
/// bend it across the palm and at 90 degrees towards the pads of the fingers.
RobotTable human_hand(const HandSize& size);

/// What the hand's joints place, in the hand frame.
struct HandPoints {
  std::array<Vec3, kFingers> tip;
  std::array<Quat, kFingers> tip_orientation;
  std::array<Vec3, kFingers> middle_joint;  ///< PIP; of the thumb the MCP
};
/// By pipeline/kinematics' forward(); `frames` is scratch that may be reused.
HandPoints hand_points(const RobotTable& hand, const HandAngles& angles, std::vector<Pose>& frames);

}  // namespace morphe::human
