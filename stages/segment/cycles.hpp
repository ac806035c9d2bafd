#pragma once

#include <cstddef>
#include <vector>

#include "stages/segment/bouts.hpp"
#include "stages/segment/contact.hpp"
#include "stages/segment/objects.hpp"

namespace morphe::segment {

/// Consecutive bouts that are one movement: out to a target, and back if `comes_home`.
struct Cycle {
  std::size_t first = 0, count = 0;  ///< bouts
  bool comes_home = false;
};

/// An object was on its way during most of the bout (or all its motion lies inside it).
bool carries(const Bout& bout, const std::vector<ObjectMotion>& motions);

/// Splits the bouts of a recording into movements: the split with the highest sum of evidence, by
/// dynamic programming over the rests between bouts. A movement from rest i to rest j counts as
/// often as it has bouts, with ¼ and
///   home    1 − (d / h)², at least −1: d the distance of rest j from rest i, h = home_radius or
///           half the reach if that is less; at least 0 where the recording ends before it; and
///           the same, if positive, taken off for every rest between that is at home
///   grasp   1 if the hand moves an object after the reach, or else ½ if it holds one before the
///           next bout or the opening is known to widen and close, −½ if that is known not to; and
///           −1 if the hand moves an object during the reach
///   away    the level distance from the shoulder gained by the reach, over the reach's way
///   target  ¼ if the reach halves the distance to a recorded object
/// Bouts outside of movements cost up to 1 each, by the way they go. Those at the head of a
/// recording cost 0.1 together, and nothing if it begins inside one: the rest of a movement without
/// its reach. No movement begins with a bout that is no reach: one that ends less than
/// `least_reach` from where it began, or is cut by the recording's begin after its peak or by its
/// end before it.
std::vector<Cycle> find_cycles(const HandSignals& signals, const HumanMotion& motion,
                               const SegmentOptions& options, const std::vector<Bout>& bouts,
                               const std::vector<SceneObject>& objects,
                               const std::vector<ObjectMotion>& motions,
                               const std::vector<Contact>& contacts);

}  // namespace morphe::segment
