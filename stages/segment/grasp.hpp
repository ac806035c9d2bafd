#pragma once

#include <string>
#include <vector>

#include "stages/segment/aperture.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_unit.hpp"
#include "stages/segment/objects.hpp"

namespace morphe::segment {

/// The end of the reach, the grasp and the start of the transport.
struct GraspTimes {
  bool grasped = false;       ///< true if the hand took an object
  bool object_moved = false;  ///< true if the recorded `object` moved
  std::string object;         ///< recorded object that was taken, or ""
  double begin_s = 0;         ///< time at which the reach ends, with or without a grasp
  double end_s = 0;           ///< time at which the transport begins; = begin_s without a grasp
  int units_used = 1;         ///< number of units in reach and grasp
  int release_unit = -1;      ///< unit that ends where the object is left again; -1 if unknown
  double begin_confidence = 1, end_confidence = 1;  ///< of these times, 0 … 1
  double probability = 1;                           ///< that the hand took an object
  ReachAperture aperture;                           ///< during the reach
};

/// Finds the grasp among the units of one movement, the first of which is the reach or its first
/// part; the last is the return if `comes_home`. The reach continues over a pause in which the hand
/// stays open.
///   If a recorded object moves with the hand, there is a grasp, and the transport is the unit in
///   which the object moves; smaller units before that are the hand closing. With until_grasped,
///   the grasp is delayed until the hand has the object: from then on its wrist travels at most
///   twice as far as the object.
///   Otherwise the transport is the unit after the reach. There is a grasp if a recorded object is
///   held for min_grasp_s before the transport, or if the evidence for it (grasp_evidence.hpp) is
///   more probable with a grasp than without. The reach has as many units as make the evidence
///   strongest; each more or less than those before the first departure costs 0.5.
/// `weak` are the units of the recording that are too small to be transports; they may be the last
/// part of the reach.
GraspTimes find_grasp(const HandRecord& hand, const std::vector<MovementUnit>& units,
                      const std::vector<MovementUnit>& weak, bool comes_home);

}  // namespace morphe::segment
