#pragma once

#include <string>
#include <vector>

#include "stages/segment/bouts.hpp"
#include "stages/segment/contact.hpp"
#include "stages/segment/objects.hpp"
#include "stages/segment/opening.hpp"

namespace morphe::segment {

/// Where the reach ends and what follows it.
struct GraspTimes {
  bool found = false;          ///< the hand took something
  bool moved = false;          ///< the recorded `object`
  std::string object;          ///< recorded object it took, or ""
  double begin_s = 0;          ///< the reach ends here, with or without a grasp
  double end_s = 0;            ///< the transport begins here; = begin_s without a grasp
  std::size_t bouts_used = 1;  ///< bouts that belong to reach and grasp
  double begin_confidence = 1, end_confidence = 1;
  Opening opening;
};

/// The grasp of one movement's bouts, the first of which is the reach (or its first part). If a
/// recorded object moves with the hand, the transport is the bout in which it does: smaller ones
/// before it are the hand closing. Otherwise the transport is the next bout, and it was a grasp if
/// the opening widened and closed again, or a recorded object was held for least_grasp before the
/// transport. The reach goes on over a pause in which the hand stays open; `weak`
/// are the bouts too small to be transports, which may still be the last of the reach.
GraspTimes find_grasp(const HandSignals& signals, const SegmentOptions& options,
                      const std::vector<ObjectMotion>& motions,
                      const std::vector<Contact>& contacts, const std::vector<Bout>& bouts,
                      const std::vector<Bout>& weak, bool comes_home);

}  // namespace morphe::segment
