#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::exports {

/// How approach and retreat are exported: as separate motions, joined with the trajectory, or not.
enum class ApproachMode { apart, joined, none };
constexpr std::array<std::string_view, 3> names_of(ApproachMode) {
  return {"apart", "joined", "none"};
}

/// The options of the exported motions.
struct MotionOptions {
  ApproachMode approach = ApproachMode::apart;
  double delay_s = 0;  ///< time for which each motion waits in its first posture [s]
  double rate_hz = 0;  ///< rate of the points [Hz]; 0 keeps the plan's own samples …
  int parts = 1;       ///< … and divides each interval between them into so many
  /// True if all points are at k / rate_hz > 0, also the last one (resample_uniformly()).
  bool uniform = false;
};

/// A motion that the robot executes without interruption.
struct PlanMotion {
  std::string name;  ///< trajectory (also if joined), approach, retreat
  Trajectory trajectory;
};

/// The motions of a plan in the order of execution, or the reason for which it cannot be exported.
struct PlanMotions {
  std::vector<PlanMotion> motions;
  std::string rejection_reason;  ///< "" if there are motions
};
/// Returns the motions of a plan, each with its wait and then resampled as the options say.
PlanMotions motions_of(const RobotModel& robot, const Plan& plan, const MotionOptions& options);

}  // namespace morphe::exports
