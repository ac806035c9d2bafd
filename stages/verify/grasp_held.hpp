#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Records a `contact` violation with the subject "opposed" and the time [s] if a plan with the
/// tolerances of the section `grasp` carries its target (a transport begins before its end) with a
/// robot that has pads on several fingers, though no two touching contacts are opposed (the angle
/// between each normal and the line to the other contact is at most atan of the friction) and
/// epsilon_lower is not positive. Records "held_drift" [m] or "held_turn" [rad] if the pads move in
/// the palm by more than 0.5 mm or 1 degree until the target is put down (the certificate's
/// figures, which verify_certificate() recomputes).
void verify_held(const RobotModel& robot, const Plan& plan, ViolationLog& violations);

}  // namespace morphe::verify
