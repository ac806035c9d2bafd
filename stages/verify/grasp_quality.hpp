#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// Returns the rows of Grasp::contacts that touch (verify_grasp_contacts() must have confirmed
/// their state).
std::vector<int> touching_contacts(const Grasp& grasp);

/// Records `quality` violations for values that the plan's contacts do not confirm
/// (verify_grasp_contacts() must have confirmed the contacts):
/// friction_coefficient, torsional_friction, mass
///                          negative, or not the config's value (if that can be read)
/// centre_of_mass, characteristic_length
///                          not those of the target's shape; 1e-6 m
/// epsilon_lower, epsilon_upper   epsilon_lower is above the recomputed upper bound, or
///                          epsilon_upper is below the recomputed lower one (wrench_bounds.hpp)
/// epsilon                  the two stored bounds differ by more than max(5 %, 1e-3)
/// required_force_worst, required_force_gravity
///                          the weight that it claims to support with 1 N is above the recomputed
///                          upper bound, or is below the lower one by more than 5 % and by 2e-3
/// available_force          not the config's max_joint_torque divided by the largest torque of any
///                          joint per normal force of any contact; 1e-6 of it
/// With fewer than two touching contacts, the last five values must be absent.
void verify_grasp_quality(const RobotModel& robot, const Plan& plan, const std::string& config,
                          ViolationLog& violations);

}  // namespace morphe::verify
