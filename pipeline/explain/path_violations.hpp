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
  /// true in a phase grasp or hold
  bool grasping = false;
};

/// A pair that is closer than allowed.
struct ClearanceViolation {
  std::string first, second;
  double begin_s = 0, end_s = 0;   ///< demonstration time
  double lacking_clearance_m = 0;  ///< missing part of the required distance
  double required_m = 0;           ///< the margin, or minus the allowed depth
  std::string_view config_key;     ///< key of the config that requires it
  bool with_object = false;
};

/// The violations of the path with which an infeasible plan ended.
struct PathViolations {
  std::optional<TipError> grasp_tip_error, other_tip_error;  ///< the worst of each
  std::vector<ClearanceViolation> contacts;                  ///< the worst first
  std::vector<Finding> jumps, limits;                        ///< the worst first
  /// Returns true if there are no violations.
  bool empty() const;
};

/// Returns the violations, from the path and the findings that repair has left (of the mapped path,
/// in files of earlier versions).
PathViolations find_path_violations(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
