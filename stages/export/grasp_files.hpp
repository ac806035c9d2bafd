#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// Returns true if a plan's grasp has contacts, so that there are grasp files to write.
bool has_contacts(const Plan& plan);

/// Returns the grasp of a plan as JSON, with the contacts, quality and grasp forces that plans.h5
/// stores (docs/formats.md). It is separate from the trajectory, because the certificate does not
/// cover the forces. `name` is that of the plan, `time_s` the time of the grasp in its motion.
std::string grasp_json(const RobotModel& robot, const Plan& plan, const std::string& name,
                       double time_s);

/// Returns the contacts as CSV, one row per contact. Empty cells stand for unknown values.
std::string contacts_csv(const Plan& plan);
/// Returns the joints as CSV, one row per joint: its position in pregrasp and grasp, its torque for
/// the grasp forces, and the servo target that produces the torque. Empty cells stand for unknown
/// values.
std::string grasp_force_csv(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::exports
