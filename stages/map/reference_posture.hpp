#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/placement.hpp"

namespace morphe::map {

/// Returns the posture [n] of the branch that is preferred among good ones (MapOptions::branch). It
/// depends on the robot, its placement and the options, but on no recording: so all movements of a
/// dataset prefer the same branch, and a small change of a recording cannot change it.
///   nearest_home     the robot's posture for a person at rest: the upper arm hangs, the forearm
///   and
///                    the hand point forward, the thumb is up; among postures whose objectives
///                    differ by less than the share, the one nearest to `home` [n]
///   nearest_posture  the posture of the options
///   best             empty; also in the joint-to-joint mode, which leaves no choice
/// A hand alone has no arm that would rest: nearest_home is `home`.
Reference find_reference(const robot::Robot& robot, const MapOptions& options,
                         const PlacementOptions& placement, const Tolerances& tolerances,
                         const JointVector& home);

}  // namespace morphe::map
