#pragma once

#include <vector>

#include "stages/segment/come_back.hpp"
#include "stages/segment/grasp_evidence.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// The end of the reach of a movement in which no recorded object tells it.
struct GraspPlace {
  int next = 1;  ///< unit after the reach
  ComeBack come_back;
  GraspEvidence evidence;
};

/// Returns the place with the strongest evidence for a grasp. `departure` is the first unit that
/// seems not to continue the reach; each unit more or less costs kLaterPlace. A hand that was at
/// the head takes nothing afterwards. Without a place that has evidence for a grasp, the reach is
/// the first unit.
GraspPlace find_place(const HandRecord& hand, const std::vector<MovementUnit>& units, int departure,
                      bool comes_home);

}  // namespace morphe::segment
