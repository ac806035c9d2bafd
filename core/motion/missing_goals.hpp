#pragma once

#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"

namespace morphe {

/// The fingertip goals that a movement lacks. Those of fingers that are closed automatically, and
/// of tips without any goal in the movement, do not count.
struct MissingGoals {
  double grasp_share = 0;  ///< of the goals in grasp and hold
  /// Greatest share in reach (with its preshape), in grasp and hold, in transport, in return, and
  /// in the time outside of all phases (`rest`); and the first of these.
  double phase_share = 0;
  PhaseKind phase = PhaseKind::rest;
  double gap_s = 0;                                     ///< longest time without any goal [s]
  double gap_begin_s = kUnknown, gap_end_s = kUnknown;  ///< between the goals around it
};

/// Counts the missing goals. stages/verify implements the same definition independently.
MORPHE_EXPORT MissingGoals missing_goals(const Goals& goals, const Movement& movement);

}  // namespace morphe
