#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records `contact` violations with the subject "<tip>/<property>" for each contact of the plan's
/// grasp that disagrees with the pads' positions at the grasp's sample (verify_grasp_pose() must
/// have confirmed that sample):
/// missing         a tip whose goal applies to its pad (tip_to_pad_share > 0) does not have exactly
///                 one contact, or another tip has a contact
/// origin          auto_closed though the tip's goals do not close a finger, or the reverse
/// link            the capsule is not that of the tip's pad (pad.hpp), or there is no such tip
/// confidence      not within 0 and 1
/// point           not on the target's surface; 1e-5 m
/// desired_point   not on the target's surface, or its distance from the tip's goal differs from
///                 the pad's radius; 1e-5 m, plus 5 cm times 1 - tip_to_pad_share. For a closed
///                 finger the distance may also be larger by the capsule's length, and may differ
///                 by the distance between the goals of the two frames around the grasp
/// demonstrated_point  not on the target's surface, or farther than 15 mm from desired_point; 1e-5
/// m;
///                 or known for a closed finger
/// signed_distance not the distance between the capsule and the target; 1e-5 m
/// penetration     deeper than the plan's max_penetration; 1e-6 m
/// pad             point - (radius + signed_distance) normal is not on the capsule's axis; 2e-5 m
/// normal          not of unit length (1e-6), or not the direction in which the distance from the
///                 surface increases most at the axis, reversed; 1e-3 rad. On an edge this
///                 direction leads from the point to the axis, so that any normal between those of
///                 the faces is valid there
/// pad_angle       not the angle between the pad's normal and that of the contact; 1e-6 rad
/// state           touching though the gap is above 0.2 mm or the angle above 60 degrees, or near
///                 though neither is
/// Also calls verify_held(). Returns false if there is no contact or one cannot be evaluated;
/// forces cannot be verified then.
bool verify_grasp_contacts(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
