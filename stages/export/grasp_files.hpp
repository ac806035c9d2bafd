#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// Returns true if a plan's grasp has contacts, so that there are grasp files to write.
bool has_contacts(const Plan& plan);

/// Returns the grasp of a plan as stored in plans.h5 (contacts, quality, squeeze). It is separate
/// from the trajectory, because the squeeze is not covered by the certificate. `time_s` is the time
/// of the grasp in the exported motion (docs/formats.md).
std::string grasp_json(const RobotModel& robot, const Plan& plan, const std::string& name,
                       double time_s);

/// Returns the contacts as a table, one row per contact. Empty cells stand for unknown values.
std::string contacts_csv(const Plan& plan);
/// Returns the joints as a table, one row per joint: its position in grasp and pregrasp, its torque
/// in the squeeze, and the servo target that produces the torque. Empty cells stand for unknown
/// values.
std::string grasp_force_csv(const RobotModel& robot, const Plan& plan);

}  // namespace morphe::exports
