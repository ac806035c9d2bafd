#pragma once

#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/scene.hpp"
#include "stages/segment/objects.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The hand and one recorded object, on the clock of the recording. An object is taken for the box
/// along its own axes that holds it, for a point if its size is not known.
struct Contact {
  std::string object;
  /// [N] from the nearest fingertip that is seen; where none is, from the wrist less a hand's
  /// length; 0 inside [m]. NaN: not seen.
  std::vector<double> distance;
  /// [N] within 0.1 s before and after, wrist or index tip go where they would if they were fixed
  /// to the object, within half the way (of 2 mm at least) that this is.
  std::vector<bool> goes_with;
  /// [N] the line from the thumb's tip to another's goes through the object, which is no wider
  /// there than a hand can hold, and the tips are at its surface (25 mm each: a tip is the finger's
  /// axis).
  std::vector<bool> held;
};

/// One for each object that has a place. Empty without signals.
std::vector<Contact> find_contacts(const HumanMotion& motion, const HandSignals& signals,
                                   const std::vector<SceneObject>& objects);

/// Of the motions of recorded objects, what this hand made: from the first to the last instant at
/// which the object goes with the hand, no farther than 0.1 m from it, if that is for half of the
/// motion or 0.1 s. So what the other hand moves is left out, and of a handover what is before or
/// behind it. Of two objects that move together (a tray and what stands on it) the one nearer to
/// the fingertips.
std::vector<ObjectMotion> moved_by_hand(const std::vector<ObjectMotion>& motions,
                                        const std::vector<Contact>& contacts,
                                        const HandSignals& signals);

/// The object that is held longest between two instants; "" if none is for `least_s`.
std::string held_between(const std::vector<Contact>& contacts, const HandSignals& signals,
                         double from_s, double to_s, double least_s);

}  // namespace morphe::segment
