#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/export.hpp"
#include "core/motion/geometry.hpp"

namespace morphe {

/// The kinds of phases (docs/steps/segment.md tells their order); files store their index as uint8.
/// `preshape` is the part of the reach in which the hand opens. `lift` and `place` are parts of the
/// first and last transport; `release`, `retreat` and `home` divide the time from the end of the
/// last transport to that of the return. `approach` is the robot's own way to the first sample.
enum class PhaseKind : std::uint8_t {
  rest,
  reach,
  preshape,
  grasp,
  hold,
  transport,
  return_phase,
  approach,
  lift,
  place,
  release,
  retreat,
  home
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 13> names_of(PhaseKind) {
  return {"rest",     "reach", "preshape", "grasp",   "hold",    "transport", "return",
          "approach", "lift",  "place",    "release", "retreat", "home"};
}

/// Returns the main phase that a lift, place, release, retreat or home refines; other kinds are
/// main phases themselves.
constexpr PhaseKind main_phase_of(PhaseKind kind) {
  if (kind == PhaseKind::lift || kind == PhaseKind::place) return PhaseKind::transport;
  return kind > PhaseKind::place ? PhaseKind::return_phase : kind;
}

/// Returns true if a plan may end with a phase of this kind (`segment.plan_until`).
constexpr bool may_end_plan(PhaseKind kind) {
  return kind >= PhaseKind::grasp && kind != PhaseKind::hold && kind != PhaseKind::approach;
}

/// The parts of a movement that are delivered if a later part cannot be planned: none, those after
/// which the hand holds no object in the air, or also those that end with the object in the air.
enum class PartialPlans : std::uint8_t { never, at_rest, in_air };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 3> names_of(PartialPlans) {
  return {"never", "at_rest", "in_air"};
}

/// A phase of a movement, in demonstration time.
struct Phase {
  PhaseKind kind = PhaseKind::rest;
  double begin_s = 0, end_s = 0;                    ///< in the demonstration
  double confidence = 1;                            ///< 0 … 1
  double begin_confidence = 1, end_confidence = 1;  ///< confidence of each boundary, 0 … 1
};

/// A reach-to-grasp. Its main phases do not overlap, except that `preshape` lies within `reach`;
/// the phases that refine them (main_phase_of) come after them in the list.
struct Movement {
  int index = 0;                  ///< index within the demonstration, from 0
  double begin_s = 0, end_s = 0;  ///< the interval that is planned
  std::vector<Phase> phases;      ///< all phases that were found, not clipped to the interval
  std::string target;  ///< name of the object that is grasped, "" if there is no such object
};

/// Returns the kind of the phase that contains a time, boundaries included: a phase that refines
/// another, else the shortest of several, else rest.
MORPHE_EXPORT PhaseKind phase_at(const std::vector<Phase>& phases, double time_s);

/// Returns the kind of the shortest main phase that contains a time, boundaries included, else
/// rest.
MORPHE_EXPORT PhaseKind main_phase_at(const std::vector<Phase>& phases, double time_s);

/// Returns true if a time is in a grasp or hold phase, boundaries included; tips must then keep
/// Tolerances::tracking_tolerance_grasp. A hold after the last transport does not count: the target
/// was put down, and the hand lets go. stages/verify implements the same rule independently.
MORPHE_EXPORT bool is_grasping_at(const Movement& movement, double time_s);

/// Returns the time at which a movement begins to carry its target: the begin of its first
/// transport in the planned interval; NaN if the target is not carried, or if there is no target.
MORPHE_EXPORT double carrying_begin_s(const Movement& movement);

/// Time by which a hand that carries the target closes earlier and opens later [s]: the smooth
/// curve through a path rings for about as long where the fingers stop and start.
inline constexpr double kSettling_s = 0.04;

/// An interval of demonstration time.
struct HeldInterval {
  double begin_s = kUnknown, end_s = kUnknown;
  /// Returns true if a time is inside; always false if the interval is unknown.
  bool contains(double time_s) const { return time_s >= begin_s && time_s <= end_s; }
};
/// Returns the interval in which the fingers of a hand that carries its target keep still: from
/// kSettling_s before the last grasp to kSettling_s after the last transport. Unknown if the
/// movement carries nothing.
MORPHE_EXPORT HeldInterval held_interval(const Movement& movement);

/// Returns the last phase of a kind, or null if there is no such phase.
MORPHE_EXPORT const Phase* last_phase(const Movement& movement, PhaseKind kind);

/// Returns the phase with which a plan until `kind` ends: the last one of that kind, else the last
/// main phase that it would refine, else the grasp; null without a grasp.
MORPHE_EXPORT const Phase* planned_end(const Movement& movement, PhaseKind kind);

/// Returns true if the movement shows that the hand let go of the target, which then rests: by a
/// return after the last transport.
MORPHE_EXPORT bool is_put_down(const Movement& movement);

}  // namespace morphe
