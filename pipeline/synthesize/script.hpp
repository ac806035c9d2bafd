#pragma once

#include "core/motion/movement.hpp"
#include "pipeline/synthesize/body_motion.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

enum class MovementKind {
  minimum_jerk,
  lognormal,
  asymmetric,
  curved,
  two_peaks,
  pause_before_grasp,
  no_grasp
};
inline constexpr const char* kMovementKindNames[] = {
    "minimum_jerk", "lognormal",          "asymmetric", "curved",
    "two_peaks",    "pause_before_grasp", "no_grasp"};

/// From still to still; when it was meant to be, the labels say when it was.
struct Bout {
  PhaseKind phase = PhaseKind::reach;  ///< or transport or go_back
  double begin_s = 0, end_s = 0;
};
struct ScriptedMovement {
  MovementKind kind = MovementKind::minimum_jerk;
  bool grasps = true;
  std::vector<Bout> bouts;
  double attach_s = 0, release_s = 0;  ///< while the hand carries the object
};

/// What one recording shows.
struct Script {
  BodyMotion motion;
  std::vector<ScriptedMovement> movements;
  double length_s = 0;            ///< from rest to rest
  double begin_s = 0, end_s = 0;  ///< what was recorded of it
  double object_radius = 0;       ///< what the hand closes on [m]
};
/// Drawn again, at most 100 times, while an angle of the arm comes within 0.05 rad of its human
/// limit.
Script draw_script(const SynthesizeOptions& options, const Subject& subject,
                   math::RandomStream& random);

}  // namespace morphe::synthesize
