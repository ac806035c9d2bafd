#pragma once

#include <cstdint>
#include <string>

#include "core/motion/geometry.hpp"

namespace morphe {

/// The result of one step of the repair sequence, or of one attempt within a step.
struct RepairStep {
  std::int32_t level = 0;                       ///< 0: a step; 1: an attempt of the preceding step
  std::string name;                             ///< "re-solve, low clearance weights"
  double begin_s = kUnknown, end_s = kUnknown;  ///< changed interval, NaN if no sample changed
  double max_joint_change = 0;                  ///< largest change of a joint [rad or m]
  std::int32_t finding_count = 0;               ///< number of findings that remain in the path
  double collision_depth_sum = 0, other_depth_sum = 0;  ///< of these findings [m]
  std::string worst_finding;  ///< the worst finding, a sentence; "" if there is no finding
  bool accepted = false;      ///< true if the result was better than the path before it
  std::string stop_reason;    ///< reason why the step ended early, "" if it was completed
};

}  // namespace morphe
