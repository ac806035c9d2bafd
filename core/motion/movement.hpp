#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/export.hpp"

namespace morphe {

/// The kinds of phases, in the order in which they may follow each other; files store their index
/// as uint8. `preshape` is the part of the reach in which the hand opens.
enum class PhaseKind : std::uint8_t { rest, reach, preshape, grasp, hold, transport, return_phase };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 7> names_of(PhaseKind) {
  return {"rest", "reach", "preshape", "grasp", "hold", "transport", "return"};
}

/// A phase of a movement, in demonstration time.
struct Phase {
  PhaseKind kind = PhaseKind::rest;
  double begin_s = 0, end_s = 0;                    ///< in the demonstration
  double confidence = 1;                            ///< 0 … 1
  double begin_confidence = 1, end_confidence = 1;  ///< confidence of each boundary, 0 … 1
};

/// A reach-to-grasp. Its phases do not overlap, except that `preshape` lies within `reach`.
struct Movement {
  int index = 0;                  ///< index within the demonstration, from 0
  double begin_s = 0, end_s = 0;  ///< the interval that is planned
  std::vector<Phase> phases;      ///< all phases that were found, not clipped to the interval
  std::string target;  ///< name of the object that is grasped, "" if there is no such object
};

/// Returns the kind of the shortest phase that contains a time, boundaries included, else rest.
MORPHE_EXPORT PhaseKind phase_at(const std::vector<Phase>& phases, double time_s);

/// Returns true if a time is in a grasp or hold phase, boundaries included; tips must then keep
/// Tolerances::tracking_tolerance_grasp. stages/verify implements the same rule independently.
MORPHE_EXPORT bool is_grasping_at(const Movement& movement, double time_s);

/// Returns the last phase of a kind, or null if there is no such phase.
MORPHE_EXPORT const Phase* last_phase(const Movement& movement, PhaseKind kind);

}  // namespace morphe
