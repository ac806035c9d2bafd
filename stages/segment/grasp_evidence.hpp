#pragma once

#include <vector>

#include "stages/segment/come_back.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// The evidence that a hand takes an object at the end of a reach, without a recorded object. Each
/// part is the logarithm of the ratio of the probabilities of an observation with and without a
/// grasp, positive for a grasp and 0 for what was not observed. Lengths are compared with others of
/// the same movement, so that people of any hand count alike.
struct GraspEvidence {
  double opening = 0;    ///< the aperture widens during the reach
  double closing = 0;    ///< it narrows before the hand moves on
  double rigidity = 0;   ///< it is constant while the hand moves on, unlike in reach and return
  double come_back = 0;  ///< the hand visits the place again, and then goes home
  double transport = 0;  ///< the hand moves on before it goes home
  double head = 0;       ///< the place is at the person's head
  double task = 0;       ///< the stated task

  double log_odds() const;
  double probability() const;  ///< 1 / (1 + e^−log_odds)
};

/// Weighs the evidence for a grasp at the end of `reach`, after which the hand moves on with
/// units[next], …; the last unit is the return if `comes_home`.
GraspEvidence weigh_grasp(const HandRecord& hand, const MovementUnit& reach,
                          const std::vector<MovementUnit>& units, int next, bool comes_home,
                          const ComeBack& come_back);

}  // namespace morphe::segment
