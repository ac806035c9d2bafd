#pragma once

#include <array>
#include <string_view>

#include "core/motion/enum_names.hpp"
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
constexpr std::array<std::string_view, 7> names_of(MovementKind) {
  return {"minimum_jerk", "lognormal",          "asymmetric", "curved",
          "two_peaks",    "pause_before_grasp", "no_grasp"};
}

/// A motion of the script from rest to rest. Its measured times are in ground_truth_labels().
struct ScriptedPhase {
  PhaseKind phase = PhaseKind::reach;  ///< reach, transport or return_phase
  double begin_s = 0, end_s = 0;
};
/// A scripted movement.
struct ScriptedMovement {
  MovementKind kind = MovementKind::minimum_jerk;
  bool grasps = true;
  std::vector<ScriptedPhase> phases;   ///< in order of time
  double attach_s = 0, release_s = 0;  ///< between them the hand carries the object, if it grasps
};

/// The content of one recording.
struct Script {
  BodyMotion motion;
  std::vector<ScriptedMovement> movements;  ///< in order of time
  double length_s = 0;                      ///< its duration from 0, with a rest at both ends
  double begin_s = 0, end_s = 0;            ///< recorded interval
  double object_radius = 0;                 ///< [m]
};
/// Draws a script. If an arm angle comes near its human limit in it, the script is drawn again; the
/// hundredth is returned in any case.
Script draw_script(const SynthesizeOptions& options, const Subject& subject,
                   math::RandomStream& random);

}  // namespace morphe::synthesize
