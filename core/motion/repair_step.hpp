#pragma once

#include <cstdint>
#include <string>

#include "core/motion/geometry.hpp"

namespace morphe {

/// The result of one step of the repair sequence, or of one attempt within a step.
struct RepairStep {
  std::int32_t level = 0;  ///< 0: a step; 1: an attempt of the preceding step
  std::string name;        ///< "re-solve, low clearance weights"
  /// The interval that it changed, NaN if it changed no sample.
  double begin_s = kUnknown, end_s = kUnknown;
  double max_joint_change = 0;     ///< largest change of a joint [rad or m]
  std::int32_t finding_count = 0;  ///< number of findings that remain in the path
  double collision_depth_sum = 0,
         other_depth_sum = 0;  ///< sums of the depths of these findings [m or rad]
  /// The worst finding, a sentence; "" if there is no finding.
  std::string worst_finding;
  /// True if the result was better than the path before it.
  bool accepted = false;
  /// Reason why the step ended early, "" if it was completed.
  std::string stop_reason;
};

}  // namespace morphe
