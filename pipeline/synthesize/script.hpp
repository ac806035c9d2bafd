#pragma once

#include "core/motion/movement.hpp"
#include "pipeline/synthesize/body_motion.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The kinds of movements (see KindWeights).
enum class MovementKind {
  minimum_jerk,
  lognormal,
  asymmetric,
  curved,
  two_peaks,
  pause_before_grasp,
  no_grasp
};
/// The names of the kinds, in the order of MovementKind.
inline constexpr const char* kMovementKindNames[] = {
    "minimum_jerk", "lognormal",          "asymmetric", "curved",
    "two_peaks",    "pause_before_grasp", "no_grasp"};

/// A scripted phase that begins and ends at rest. Its times are the scripted ones; the labels
/// contain the actual ones.
struct ScriptedPhase {
  /// Reach, transport or return_phase.
  PhaseKind phase = PhaseKind::reach;
  /// The scripted times [s].
  double begin_s = 0, end_s = 0;
};
/// A scripted movement.
struct ScriptedMovement {
  /// The kind of the movement.
  MovementKind kind = MovementKind::minimum_jerk;
  /// True if the movement grasps an object.
  bool grasps = true;
  /// The phases, in order of time.
  std::vector<ScriptedPhase> phases;
  /// Interval during which the hand carries the object [s].
  double attach_s = 0, release_s = 0;
};

/// The content of one recording.
struct Script {
  /// The motion of the body.
  BodyMotion motion;
  /// The movements, in order of time.
  std::vector<ScriptedMovement> movements;
  /// Duration from rest to rest [s].
  double length_s = 0;
  /// Recorded interval of the script [s].
  double begin_s = 0, end_s = 0;
  /// Radius of the grasped object [m].
  double object_radius = 0;
};
/// Draws a script. It is drawn again, at most 100 times, while an angle of the arm is within 0.05
/// rad of its human limit.
Script draw_script(const SynthesizeOptions& options, const Subject& subject,
                   math::RandomStream& random);

}  // namespace morphe::synthesize
