#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// The treatment of approach and retreat: exported as separate motions, joined with the trajectory,
/// or omitted.
enum class ApproachMode { apart, joined, none };
constexpr std::array<std::string_view, 3> names_of(ApproachMode) {
  return {"apart", "joined", "none"};
}

/// The options of the exported motions.
struct MotionOptions {
  ApproachMode approach = ApproachMode::apart;
  double delay_s = 0;  ///< time for which each motion waits in its first posture [s]
  double rate_hz = 0;  ///< rate of the points [Hz]; 0 keeps the plan's own samples
};

/// A motion that the robot executes without interruption.
struct PlanMotion {
  std::string what;  ///< trajectory, approach, retreat; trajectory for joined motions
  Trajectory trajectory;
};

/// The motions of a plan with a trajectory in the order of execution, or the reason for their
/// absence.
struct PlanMotions {
  std::vector<PlanMotion> motions;
  std::string rejection_reason;
};
/// Returns the motions of a plan.
PlanMotions motions_of(const RobotModel& robot, const Plan& plan, const MotionOptions& options);

}  // namespace morphe::exports
