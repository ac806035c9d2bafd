#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/named.hpp"

namespace morphe {

/// What a person does, in the order in which phases may follow each other; a file's uint8 phase is
/// the number here. `preshape` is the part of the reach in which the hand opens.
enum class PhaseKind : std::uint8_t { rest, reach, preshape, grasp, hold, transport, go_back };
constexpr std::array<std::string_view, 7> names_of(PhaseKind) {
  return {"rest", "reach", "preshape", "grasp", "hold", "transport", "return"};
}

struct Phase {
  PhaseKind kind = PhaseKind::rest;
  double begin_s = 0, end_s = 0;                    ///< in the demonstration
  double confidence = 1;                            ///< 0 … 1
  double begin_confidence = 1, end_confidence = 1;  ///< how sure each boundary is, 0 … 1
};

/// One reach-to-grasp inside a demonstration. Phases follow each other without overlap, except
/// that `preshape` lies inside `reach`.
struct Movement {
  int index = 0;                  ///< 0, 1, … in the demonstration
  double begin_s = 0, end_s = 0;  ///< what is planned
  std::vector<Phase> phases;      ///< clipped to nothing: all that were found
  std::string target;             ///< object grasped, "" if none
};

/// The phase at a time: the shortest one that contains it (borders do), rest if none.
MORPHE_EXPORT PhaseKind phase_at(const std::vector<Phase>& phases, double time_s);

/// Whether the hand grasps or holds at a time, borders included: goals count there by the tighter
/// tolerance. The judge of plan files (stages/verify) has the same rule of its own.
MORPHE_EXPORT bool grasping_at(const Movement& movement, double time_s);

/// The last phase of a kind, null if there is none.
MORPHE_EXPORT const Phase* last_phase(const Movement& movement, PhaseKind kind);

}  // namespace morphe
