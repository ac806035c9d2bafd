#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::exports {

/// Whether a plan names contacts, so that there is something to write.
bool names_contacts(const Plan& plan);

/// The grasp of a plan as plans.h5 holds it (contacts, quality, squeeze), beside the trajectory and
/// never part of it: a squeeze is beyond what the certificate speaks of. `time_s`: of the grasp in
/// the exported motion (docs/formats.md).
std::string grasp_json(const RobotTable& robot, const Plan& plan, const std::string& name,
                       double time_s);

/// The same as tables: a row a contact; a row a joint, with the postures of grasp and pregrasp, the
/// torque that it bears in the squeeze and where its servo must be sent for it. Empty cells: not
/// known.
std::string contacts_csv(const Plan& plan);
std::string squeeze_csv(const RobotTable& robot, const Plan& plan);

}  // namespace morphe::exports
