#pragma once

#include <cstdint>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "pipeline/planning/approach_options.hpp"
#include "pipeline/planning/planner.hpp"

namespace morphe::planning {

/// All joints at home. The joints that the options name are the robot's.
JointVector home_posture(const RobotTable& robot, const ApproachOptions& options);

/// Plans, times and certifies the approach of an executable plan from home to its first sample, and
/// the retreat from its last one, in the plan's scene as it stands at these times. Refused:
/// no_approach, no_retreat, where there is no such way. A retreat lets go: what the hand touches
/// may be touched on the way; where no other is found it goes back the way it came. A target in the
/// hand at the end would have to be carried home: there is no retreat then.
Refusal add_approach(const Planner& planner, const ApproachOptions& options, std::uint64_t seed,
                     Plan& plan);

}  // namespace morphe::planning
