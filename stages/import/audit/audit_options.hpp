#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/recording_flag.hpp"

namespace morphe::imports {

/// Options of the audit (config section `audit`).
struct AuditOptions {
  /// Flags that make a movement infeasible (`doubtful_recording`), unless they are mended or
  /// accepted: by default those that the robot would act upon.
  std::vector<FlagCode> refuse = {
      FlagCode::exchanged_digits,   FlagCode::spike,       FlagCode::step,
      FlagCode::lost_rows,          FlagCode::target_away, FlagCode::missing_goals,
      FlagCode::incomplete_movement};
  double max_missing_goal_share = 0.2;  ///< of the goals in grasp and hold; more is missing_goals
  double max_goal_gap_s = 0.3;          ///< without any goal; longer is missing_goals
};
template <class Fields>
void fields(Fields& f, AuditOptions& o) {
  f("refuse", o.refuse);
  f("max_missing_goal_share", o.max_missing_goal_share, bounds::kShareBelow1);
  f("max_goal_gap_s", o.max_goal_gap_s, bounds::kDuration);
}

}  // namespace morphe::imports
