#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/collision/continuous_check.hpp"
#include "core/motion/plan.hpp"

namespace morphe::check {

/// The collision engine: exact distances, certified between samples; or the result of FCL alone, at
/// samples less than a margin apart.
enum class Engine { analytic, fcl };
constexpr std::array<std::string_view, 2> names_of(Engine) { return {"analytic", "fcl"}; }

/// The options of path checks.
struct CheckOptions {
  Tolerances tolerances;
  Engine engine = Engine::analytic;
  /// a joint step that may be a jump between IK branches [rad per 10 ms]; for a prismatic joint, a
  /// tenth of it [m per 10 ms]
  double jump_threshold = 0.06;
};
template <class Fields>
void fields(Fields& f, CheckOptions& o) {
  f("required_clearance", o.tolerances.required_clearance);
  f("max_penetration", o.tolerances.max_penetration);
  f("tracking_tolerance_grasp", o.tolerances.tracking_tolerance_grasp);
  f("tracking_tolerance", o.tolerances.tracking_tolerance);
  f("max_unreachable_share", o.tolerances.max_unreachable_share);
  f("max_tip_error", o.tolerances.max_tip_error);
  f("engine", o.engine);
  f("jump_threshold", o.jump_threshold);
}
/// Returns an error sentence, or "" if the options are valid.
std::string validation_error(const CheckOptions& options);

/// Returns true if sample k of a path belongs to grasp or hold, so that its tips have the tighter
/// tolerance. Samples next to the grasp belong to it, because part of the motion between them does.
bool counts_as_grasp(const Movement& movement, const std::vector<double>& time, std::size_t k);

/// Returns everything that prevents a path from being executed, one finding for each cause and pair
/// of names in a row of samples, ordered by begin, then cause and names; empty if the path is free.
/// Times are the path's demonstration times; the tips are compared with the goals at these times.
///   self, object, table  the pair is closer than allowed, at a sample or on the straight line to
///                        the next one (an object named "table" is the table). Extends from the
///                        last sample before to the first one after. Depth: the missing clearance
///                        at the worst place that was evaluated; if no collision was found but
///                        freedom could not be proved either, the band of 0.1 mm that is left
///                        undecided, less the slack. A target with an attached_frame moves with it
///                        along the path
///   limit                a joint exceeds a limit by more than 1e-9 rad (or is not a number);
///                        depth: the excess
///   tracking             a tip is farther from its goal than its phase allows (grasp and hold, and
///                        the samples next to them: tracking_tolerance_grasp); depth: the excess
///   jump                 a joint's step is larger than jump_threshold in its time and 3 times the
///   mean
///                        of its neighbours, so that a fast smooth motion is not a jump. Steps to
///                        or from a planned sample are exempt. Depth: the excess over
///                        jump_threshold
std::vector<Finding> check_path(const collision::CollisionWorld& world, const Goals& goals,
                                const Movement& movement, const JointPath& path,
                                const CheckOptions& options);

}  // namespace morphe::check
