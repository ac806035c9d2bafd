#pragma once

#include <string>
#include <vector>

#include "stages/segment/aperture.hpp"
#include "stages/segment/interaction.hpp"
#include "stages/segment/movement_units.hpp"
#include "stages/segment/objects.hpp"

namespace morphe::segment {

/// The end of the reach, the grasp and the start of the transport.
struct GraspTimes {
  bool grasped = false;        ///< true if the hand took an object
  bool object_moved = false;   ///< true if the recorded `object` moved
  std::string object;          ///< recorded object that was taken, or ""
  double begin_s = 0;          ///< time at which the reach ends, with or without a grasp
  double end_s = 0;            ///< time at which the transport begins; = begin_s without a grasp
  std::size_t units_used = 1;  ///< number of units in reach and grasp
  /// Confidences of the two times, 0 … 1.
  double begin_confidence = 1, end_confidence = 1;
  /// Aperture during the reach.
  ReachAperture opening;
};

/// Finds the grasp among the units of one movement, the first of which is the reach (or its first
/// part). If a recorded object moves with the hand, the transport is the unit in which it moves;
/// smaller units before that are the hand closing. With until_grasped, a hand that pauses before it
/// has the moving object (its wrist travels more than twice as far as the object) grasps that much
/// later. Otherwise the transport is the next unit, and there was a grasp if the aperture widened
/// and closed again, or a recorded object was held for min_grasp_s before the transport. The reach
/// continues over a pause in which the hand stays open. `weak` are the units too small to be
/// transports, which may still be the last of the reach.
GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<ObjectMotion>& motions,
                      const std::vector<HandObjectInteraction>& contacts,
                      const std::vector<MovementUnit>& bouts, const std::vector<MovementUnit>& weak,
                      bool comes_home);

}  // namespace morphe::segment
