#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/collision/continuous_check.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/motion/plan.hpp"

namespace morphe::check {

/// The collision engine: certified exact distances (analytic), or FCL at instants between which no
/// body travels farther than the margin.
enum class Engine { analytic, fcl };
/// Returns the names of the engines in configurations.
constexpr std::array<std::string_view, 2> names_of(Engine) { return {"analytic", "fcl"}; }

/// The options of path checks.
struct CheckOptions {
  Tolerances tolerances;
  Engine engine = Engine::analytic;
  /// Joint step that may be a jump between IK branches [rad per 10 ms or 0.1 m per 10 ms].
  double jump_threshold = 0.06;
};
template <class Fields>
void fields(Fields& f, CheckOptions& o) {
  f("required_clearance", o.tolerances.required_clearance, bounds::kLength);
  f("max_penetration", o.tolerances.max_penetration, bounds::kLength);
  f("tracking_tolerance_grasp", o.tolerances.tracking_tolerance_grasp, bounds::kPositiveLength);
  f("tracking_tolerance", o.tolerances.tracking_tolerance, bounds::kPositiveLength);
  f("max_unreachable_share", o.tolerances.max_unreachable_share, bounds::kShareBelow1);
  f("max_tip_error", o.tolerances.max_tip_error, bounds::kPositiveLength);
  f("max_missing_goal_share", o.tolerances.max_missing_goal_share, bounds::kShare);
  f("max_goal_gap_s", o.tolerances.max_goal_gap_s, bounds::kDuration);
  f("engine", o.engine);
  f("jump_threshold", o.jump_threshold, bounds::kPositiveAngle);
}

/// Returns true if sample k of a path, or one next to it, is in grasp or hold. Its tips then have
/// the tighter tolerance, because part of the motion between these samples is in grasp or hold.
bool counts_as_grasp(const Movement& movement, const std::vector<double>& time, std::ptrdiff_t k);

/// Returns the findings that prevent a path from being executed; empty if the path is free. There
/// is one for each cause and pair of names in a row of samples, ordered by begin, then cause and
/// names. Times are the path's demonstration times; the tips are compared with the goals at these
/// times.
///   self, object, table  the pair is closer than allowed, at a sample or on the straight line to
///                        the next one (an object named "table" is the table; a target with an
///                        attached_frame moves with it). It extends from the last sample before to
///                        the first one after. Depth: the missing clearance at the worst place that
///                        was evaluated; of a line that was neither found in collision nor proved
///                        free, 0.1 mm less the slack
///   limit                a joint exceeds a limit by more than 1e-9 rad (or is not a number);
///                        depth: the excess
///   tracking             a tip is farther from its goal than allowed (counts_as_grasp); depth: the
///                        excess
///   jump                 a joint's step, scaled to 10 ms, exceeds jump_threshold and 3 times the
///                        mean of the steps beside it (a fast smooth motion is not a jump), and
///                        neither end is planned; depth: the excess over jump_threshold
std::vector<Finding> check_path(const collision::CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options);

}  // namespace morphe::check
