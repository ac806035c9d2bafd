#pragma once

#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// Returns the sentences as one text, separated by "; " as in a plan's detail.
std::string join_sentences(const std::vector<std::string>& sentences);

/// Returns the warnings about an executable plan, as one text:
///   - tips with goals in only some frames, and a hand of which only one tip has goals
///   - a scaled hand, a moved base, and meshes with holes
///   - the delay against the demonstration, if `with_delay` (retime mode catch_up)
///   - phases with uncertain borders, also because the recording is cut off in them
///   - the notes of the reconstruction
std::string warnings(const collision::CollisionWorld& world, const Goals& goals,
                     const Movement& movement, const HumanMotion& motion,
                     const Trajectory& trajectory, bool with_delay);

/// Returns a warning with both figures if the goals of thumb and index are farther from each other
/// than the robot's tips can be, or "".
std::string opening_warning(const RobotModel& robot, const Goals& goals);

/// Returns a warning if no contact forces of an evaluated grasp are in balance, or "".
std::string grasp_force_warning(const Grasp& grasp);

/// Returns a warning that names the contacts of a grasp which are only near the target, with gap
/// and angle of their pads, or "".
std::string near_contacts_warning(const Grasp& grasp);

/// Returns a warning if the movement carries its target, for a config without the section `grasp`,
/// or "".
std::string unchecked_carrying_warning(const Movement& movement);

/// Returns a warning if the upper arm's mean direction error is above 45 degrees, or "".
std::string humanlikeness_warning(const Certificate& certificate, const Goals& goals);

}  // namespace morphe::planning
