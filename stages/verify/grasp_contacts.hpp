#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// Notes `contact`, "<tip>/<what>", for a contact of the plan's grasp that is not as the pads lie
/// at the grasp's sample (judge_grasp_pose() must have found that sample):
/// missing     a tip whose goal there is its pad's has none, or more than one; or another has one
/// origin      closed, and the tip's goals do not close a finger; or the other way round
/// link        the capsule is not that of the tip's pad (pad.hpp), or there is no such tip
/// point       off the target's surface; 1e-5 m
/// asked       likewise, or not the pad's radius from where its goal has the pad's centre; of a
///             closed finger the radius and at most the capsule's length, to what it still closes
///             until the next frame
/// pad         point - (radius + gap) normal is off the capsule's axis; 2e-5 m
/// gap         not the distance between the capsule and the target; 1e-5 m
/// penetration deeper than the plan's contact_depth; 1e-6 m
/// normal      not unit (1e-6), or beside the way on which the distance grows fastest from the axis
///             outwards; 1e-3 rad. On an edge that way is the one from the point to the axis, so
///             that any normal between those of the faces is good, where the pad lies on it
/// pad_angle   not the angle between the pad's middle and the normal; 1e-6 rad
/// confidence  not within 0 and 1
/// False if there is none, or one cannot be told: then no force can be judged.
bool judge_grasp_contacts(const RobotTable& robot, const Plan& plan, ViolationRuns& runs);

}  // namespace morphe::verify
