#pragma once

#include "core/humanlike/arm_posture.hpp"

namespace morphe::humanlike {

/// Returns true if the robot can turn its elbow about the line from shoulder to wrist: at least
/// four joints move the wrist by more than 1 mm/rad at one of the postures [.., n], and the
/// shoulder by at most 20 mm/rad, which excludes the trunk and includes an arm whose shoulder axes
/// miss each other by that much. False for an arm without an elbow.
bool has_elbow_circle(const robot::Robot& robot, const JointRows& postures);

/// The least angles between the arms' directions that one wrist allows [rad]; NaN if unknown.
struct LeastDirectionErrors {
  double upper_arm = kUnknown, forearm = kUnknown;
};
/// Returns the least angle of each link over the circle on which the robot's elbow can be at this
/// wrist, each for itself. At the distance d from shoulder to wrist, the links L1 and L2 form the
/// angles
///   cos alpha = (L1² + d² - L2²) / (2 L1 d),  cos beta = (L2² + d² - L1²) / (2 L2 d)
/// with the line from shoulder to wrist, a, so that the least angles to the person's directions u
/// and f are |angle(u, a) - alpha| and |angle(f, a) - beta|. Joint limits and obstacles are
/// ignored.
LeastDirectionErrors least_direction_errors(const ArmPoints& human, const ArmPoints& robot);

/// Returns how far the robot's wrist W is from the place at which both links have the person's
/// directions, W - (S + L1 u + L2 f) [m], in the frame of the points; NaN if unknown.
Vec3 wrist_offset(const ArmPoints& human, const ArmPoints& robot);

}  // namespace morphe::humanlike
