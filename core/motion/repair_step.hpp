#pragma once

#include <cstdint>
#include <string>

#include "core/motion/geometry.hpp"

namespace morphe {

/// The result of one step of the repair sequence, or of one attempt within a step.
struct RepairStep {
  std::int32_t level = 0;  ///< 0: a step; 1: an attempt of the preceding step
  std::string name;        ///< "re-solve gently"
  /// The interval that it changed, NaN if it changed no sample.
  double begin_s = kUnknown, end_s = kUnknown;
  double change = 0;                  ///< largest change of a joint [rad or m]
  std::int32_t findings = 0;          ///< number of findings that remain in the path
  double collisions = 0, others = 0;  ///< sums of the depths of these findings [m or rad]
  /// The worst finding, a sentence; "" if there is no finding.
  std::string worst;
  /// True if the result was better than the path before it.
  bool kept = false;
  /// Reason why the step ended early, "" if it was completed.
  std::string ended;
};

}  // namespace morphe
