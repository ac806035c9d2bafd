#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::exports {

/// What becomes of the ways from home and back: motions of their own, one with the trajectory, left
/// out.
enum class Ways { apart, joined, none };
constexpr std::array<std::string_view, 3> names_of(Ways) { return {"apart", "joined", "none"}; }

struct MotionOptions {
  Ways approach = Ways::apart;
  double delay_s = 0;  ///< each motion waits in its first posture
  double rate_hz = 0;  ///< 0: at the plan's own samples
};

/// What a robot does in one go.
struct PlanMotion {
  std::string what;  ///< trajectory, approach, retreat; with ways joined: trajectory
  Trajectory trajectory;
};

/// The motions of a plan with a trajectory in the order in which they are run, or why there are
/// none.
struct PlanMotions {
  std::vector<PlanMotion> motions;
  std::string why;
};
PlanMotions motions_of(const RobotTable& robot, const Plan& plan, const MotionOptions& options);

}  // namespace morphe::exports
