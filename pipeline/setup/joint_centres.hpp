#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// A point fixed in a frame that corresponds to a joint of the human.
struct JointCentre {
  int frame = -1;
  Vec3 position = Vec3::Zero();  ///< in the frame [m]
  Provenance sure = Provenance::derived;
  double axis_distance_m = 0;  ///< largest distance of the point from the axes that define it
};

/// The shoulder, elbow and wrist of an arm, derived from its axes, not from the frames' origins:
///   shoulder  the point on the first axis nearest to the intersection of the first axes: of three
///   if
///             the arm has seven and they pass one point within 10 mm, otherwise of two
///   elbow     the projection of the shoulder onto the axis after those
///   wrist     the intersection of the last axes but one and two, else of the last two, else the
///             origin of the last joint but one (assumed)
/// For an arm of fewer than three joints: the origins of the first and the last joint (assumed).
struct ArmCentres {
  JointCentre shoulder, elbow, wrist;
};
/// Returns the joint centres of an arm with these moving frames.
ArmCentres arm_centres(const Kinematics& robot, const std::vector<int>& arm);

/// Returns the frame of a finger's middle joint. Of the hinges with axes within 25 degrees of the
/// last one's, it is the last but one of at least three, or the last of two; otherwise -1.
int middle_joint(const Kinematics& robot, const Finger& finger);

}  // namespace morphe::setup
