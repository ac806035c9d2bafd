#pragma once

#include <string>
#include <vector>

#include "stages/segment/bouts.hpp"

namespace morphe {

/// Where the reach ends and what follows it.
struct GraspTimes {
  bool found = false;          ///< the hand took something
  std::string object;          ///< recorded object it moved, or ""
  double begin_s = 0;          ///< the reach ends here, with or without a grasp
  double end_s = 0;            ///< the transport begins here; = begin_s without a grasp
  double preshape_s = 0;       ///< the hand starts to open
  std::size_t bouts_used = 1;  ///< bouts that belong to reach and grasp
  double begin_confidence = 1, end_confidence = 1;
  double opening_confidence = 1;  ///< how far the hand opened beyond what was asked
};

/// The grasp of one cycle of bouts, the first of which is the reach. If a recorded object moves,
/// the transport begins there: small bouts before it are the hand closing, and a reach that runs
/// into it without a pause ends at its slowest point. Otherwise the transport is the next bout, and
/// it was a grasp if the opening widened during the reach and closed again by the transport.
GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<SceneObject>& objects, std::vector<Bout>& bouts);

}  // namespace morphe
