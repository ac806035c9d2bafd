#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Returns the contacts that touch, that is, whose pads are at most 2 mm from the surface. [rows of
/// Grasp::contacts]
std::vector<std::size_t> touching_contacts(const Grasp& grasp);

/// Records `quality` violations for values that the plan's contacts do not confirm
/// (verify_grasp_contacts() must have confirmed the contacts):
/// friction, torsion, mass    negative, or not the config's value (if that can be read)
/// centre, characteristic_length       not those of the target's shape; 1e-6 m
/// epsilon_lower              above an upper bound that was found; epsilon_upper below a lower
///                            bound (wrench_bounds.hpp)
/// epsilon                    the two bounds are farther apart than 5 % or 1e-3
/// required_force_worst, required_force_gravity  less than an upper bound of the supported weight
/// permits, or more
///                            than 5 % (and 2e-3 of that weight) above the value that a lower bound
///                            requires
/// given                      not the config's joint_torque divided by the largest lever of any
///                            contact; 1e-6 of it
/// With fewer than two touching contacts the last six values must be absent.
void verify_grasp_quality(const RobotModel& robot, const Plan& plan, const std::string& config,
                          ViolationCollector& runs);

}  // namespace morphe::verify
