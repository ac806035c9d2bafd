#pragma once

#include <string>
#include <vector>

namespace morphe {

/// Phase names in the order in which they may follow each other; a file's uint8 phase is the
/// index here. `preshape` is the part of the reach in which the hand opens.
inline constexpr const char* kPhaseNames[] = {"rest", "reach",     "preshape", "grasp",
                                              "hold", "transport", "return"};

struct Phase {
  std::string name;
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

/// Index into kPhaseNames of the phase at a time: the shortest one that contains it, "rest" if
/// none.
int phase_at(const std::vector<Phase>& phases, double time_s);

}  // namespace morphe
