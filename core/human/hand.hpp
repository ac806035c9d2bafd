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

/// Returns the hand size of an average adult: the mean of women's and men's ratios in ANSUR II.
HandSize hand_size_of_stature(double stature_m);

/// The angles of a hand [rad]. At zero, the hand is flat with the thumb in its plane.
struct HandAngles {
  /// kHandAngleNames: flexion (mcp, pip, dip, ip) bends towards the pad, abduction tilts towards
  /// the thumb's side, thumb_rotation moves the thumb out of the palm's plane into opposition.
  std::array<double, kHandAngleCount> joint{};
  double palm_arch =
      0;  ///< lowers the little finger's metacarpal; the ring finger's by 20/28 of it
};

/// Returns the human hand as a kinematic tree, with the ratios of Buchholz et al. (1992) to hand
/// length and breadth (hand_proportions.hpp).
///   base     the hand frame of HumanMotion: origin at the wrist, z to the fingers, y to the side
///            of the thumb, x out of the palm
///   joints   kHandAngleNames, then palm_arch, with human limits; rates are not limited
///   tips     thumb … little, on the finger's axis, with z along the distal bone, x out of the pad
///   fingers  abduction about -x, then flexions about y
///   thumb    at its CMC joint, rotation about -z and abduction about -x, at zero 30 degrees beside
///            z; then flexions of MCP and IP, which bend it across the palm at zero rotation and
///            towards the pads of the fingers at 90 degrees
RobotModel human_hand(const HandSize& size);

/// The points of the hand in the hand frame [m].
struct HandPoints {
  std::array<Vec3, kFingerCount> tip;
  std::array<Quat, kFingerCount> tip_orientation;
  std::array<Vec3, kFingerCount> middle_joint;  ///< PIP; MCP of the thumb
};
/// Computes the points of a hand made by human_hand(). `frames` is a buffer that can be reused.
HandPoints hand_points(const RobotModel& hand, const HandAngles& angles, std::vector<Pose>& frames);

}  // namespace morphe::human
