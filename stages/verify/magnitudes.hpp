#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation_collector.hpp"

namespace morphe::verify {

/// Records `structure` violations for magnitudes that no valid plan has and that would make the
/// searches along a motion run practically without end: positions and lengths of the robot, the
/// scene and the goals beyond 1000 km; joints beyond 1e6 rad or m; ratios of coupled frames beyond
/// 1000; a motion of more than 6 hours; goals at more than 100,000 per second, or so dense that the
/// motion has more than 4,000,000 of their steps, or more than 1000 plus 100 per sample. Values
/// that are not finite are left to verify_structure(). Returns false if there are any violations.
bool verify_magnitudes(const RobotModel& robot, const Plan& plan, ViolationCollector& runs);

/// Checks the magnitudes of the motion alone, for an approach or a retreat.
bool verify_magnitudes(const Trajectory& motion, ViolationCollector& runs);

}  // namespace morphe::verify
