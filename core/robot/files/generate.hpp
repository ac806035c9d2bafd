#pragma once

#include <numbers>
#include <string>

#include "core/motion/robot_table.hpp"

namespace morphe::robot {

/// The paper's arms of n joints: n / 3 spherical joints (three axes that meet, about x, y and z of
/// the link before; z along the link after) and as many equal links; what n leaves beyond a
/// multiple of 3 stands at the tip and turns it about x, then y. At zero the arm points along the
/// base's z.
struct ArmShape {
  int joints = 6;                   ///< 6 … 60
  double length = 0;                ///< from the shoulder to the wrist [m]
  double limit = std::numbers::pi;  ///< every joint turns this far both ways [rad]
  /// No such arm was built: assumed, for the time law alone [rad/s], [rad/s^2], [rad/s^3].
  double velocity = 2, acceleration = 10, jerk = 100;
  double radius = 0;  ///< of a capsule along each link; 0: none [m]
};

/// A hand of m fingers: the human's thumb, and m - 1 fingers between the human's index and little
/// finger, bases, phalanges and ranges taken at equal steps from one to the other (m = 5: the human
/// hand's proportions themselves). Four driven joints a finger. Fingers are called thumb, index …
/// little if m = 5, else thumb, finger1, …; theirs is the share along the curve of fingertips.
struct HandShape {
  int fingers = 5;                 ///< 3 … 12, the thumb included
  double length = 0, breadth = 0;  ///< wrist to middle fingertip; across the knuckles [m]
  double velocity = 3, acceleration = 30, jerk = 300;  ///< assumed, as above
  /// Of a capsule along each phalanx and each metacarpal (those of the fingers belong to the palm);
  /// 0: none [m].
  double radius = 0;
};

/// "" or what is wrong with a shape.
std::string why_invalid(const ArmShape& shape);
std::string why_invalid(const HandShape& shape);

/// Robots of their own: the arm's chain is called `arm`, its wrist is the end-effector; the hand's
/// base is its palm. The shapes must pass why_invalid().
RobotTable generate_arm(const ArmShape& shape);
RobotTable generate_hand(const HandShape& shape);
/// The hand mounted on the arm: wrist_from_palm from the frame at the arm's end.
RobotTable generate_arm_hand(const ArmShape& arm, const HandShape& hand,
                             const Pose& wrist_from_palm = Pose::Identity());

}  // namespace morphe::robot
