#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// A place that a joint of the human corresponds to, fixed in a frame.
struct JointCentre {
  int frame = -1;
  Vec3 in_frame = Vec3::Zero();
  Sure sure = Sure::derived;
  double miss_m = 0;  ///< how far the axes pass it by, at most
};

/// Shoulder, elbow and wrist of an arm, from where its axes meet and not from where its frames
/// happen to be:
///   shoulder  nearest to the first axes, as many as pass one point within 10 mm, two at least, on
///             the first of them
///   elbow     the foot of the perpendicular from the shoulder on the next axis
///   wrist     where the last two axes before the flange's own meet, else where the last two do
struct ArmCentres {
  JointCentre shoulder, elbow, wrist;
};
ArmCentres arm_centres(const Kinematics& robot, const std::vector<int>& arm);

/// A finger's middle joint: the last hinge but one of three in a row that bend the same way (axes
/// within 25 degrees), else the last one. -1: it has but one.
int middle_joint(const Kinematics& robot, const Finger& finger);

}  // namespace morphe::setup
