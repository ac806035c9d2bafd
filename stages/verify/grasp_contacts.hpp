#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `contact` violations with the subject "<tip>/<property>" for each contact of the plan's
/// grasp that disagrees with the pads' positions at the grasp's sample (verify_grasp_pose() must
/// have confirmed that sample):
/// missing     a tip whose goal is that of its pad has no contact or more than one, or a tip with
///             another goal has a contact
/// origin      closed though the tip's goals do not close a finger, or the reverse
/// link        the capsule is not that of the tip's pad (pad.hpp), or there is no such tip
/// point       not on the target's surface; 1e-5 m
/// asked       not on the target's surface, or its distance from the goal of the pad's centre
///             differs from the pad's radius; for a closed finger the distance may exceed the
///             radius by the capsule's length, and both bounds are relaxed by the motion until the
///             next frame
/// pad         point - (radius + gap) normal is not on the capsule's axis; 2e-5 m
/// gap         not the distance between the capsule and the target; 1e-5 m
/// penetration deeper than the plan's max_penetration; 1e-6 m
/// normal      not of unit length (1e-6), or not the direction of steepest increase of the distance
///             from the axis outwards; 1e-3 rad. On an edge this direction leads from the point to
///             the axis, so that any normal between those of the faces is valid there
/// pad_angle   not the angle between the pad's middle and the normal; 1e-6 rad
/// confidence  not within 0 and 1
/// Returns false if there is no contact or one cannot be evaluated; forces cannot be verified then.
bool verify_grasp_contacts(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

}  // namespace morphe::verify
