#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// A tip that is farther from its goal than its phase allows, at the time of the largest excess.
struct TipError {
  std::string tip;
  double time_s = 0;  ///< demonstration time
  double error_m = 0, allowed_m = 0;
  bool grasping = false;  ///< true in a phase grasp or hold
};

/// A pair of bodies that is closer than allowed.
struct ClearanceViolation {
  std::string first, second;
  double begin_s = 0, end_s = 0;   ///< demonstration time
  double lacking_clearance_m = 0;  ///< missing part of the required distance
  double required_m = 0;           ///< the margin, or minus the allowed depth
  std::string_view config_key;     ///< key of the config that requires it
  bool with_object = false;        ///< false for a self-collision
};

/// The violations of the path with which an infeasible plan ended.
struct PathViolations {
  std::optional<TipError> grasp_tip_error, other_tip_error;  ///< the worst of all tips and frames
  std::vector<ClearanceViolation> contacts;                  ///< the worst first
  std::vector<Finding> jumps, limits;                        ///< the worst first
  /// Returns true if there are no violations.
  bool empty() const;
};

/// Returns the violations of the plan's path. For files of earlier versions, which do not store its
/// findings, those of the mapped path are used.
PathViolations find_path_violations(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
