#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// A point fixed in a frame that corresponds to a joint of the human.
struct JointCentre {
  /// The index of the frame.
  int frame = -1;
  /// The position in the frame [m].
  Vec3 position = Vec3::Zero();
  /// The certainty of the position.
  Provenance sure = Provenance::derived;
  /// Largest distance of the point from the axes [m].
  double axis_distance_m = 0;
};

/// The shoulder, elbow and wrist of an arm, derived from the intersections of its axes rather than
/// from the origins of its frames:
///   shoulder  the point on the first axis nearest to the first axes; these are three if they pass
///             one point within 10 mm, otherwise two
///   elbow     the projection of the shoulder onto the next axis
///   wrist     the intersection of the last two axes before that of the flange, otherwise of the
///             last two
struct ArmCentres {
  /// The centres.
  JointCentre shoulder, elbow, wrist;
};
/// Computes the joint centres of an arm.
ArmCentres arm_centres(const Kinematics& robot, const std::vector<int>& arm);

/// Returns the middle joint of a finger: the last hinge but one of at least three that bend in the
/// same way (axes within 25 degrees), otherwise the last one. Returns -1 if there is only one.
int middle_joint(const Kinematics& robot, const Finger& finger);

}  // namespace morphe::setup
