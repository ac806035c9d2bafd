#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/report/display_motion.hpp"

namespace morphe::report {

/// The instant at which an infeasible plan fails, with a description of the failure.
struct WorstInstant {
  double demonstration_s = 0;  ///< time in the recording
  std::string sentence;
};

/// Finds the instant of an infeasible plan at which the condition named by its reason is violated
/// most: that of the least slack for a collision, of the tip farthest beyond its tolerance for
/// goals that are missed. For other reasons, or if the motions violate no such condition, it is the
/// middle of the mapped path's worst finding; nullopt without findings.
std::optional<WorstInstant> worst_instant(const robot::Robot& robot, const Plan& plan,
                                          const std::vector<DisplayMotion>& motions);

}  // namespace morphe::report
