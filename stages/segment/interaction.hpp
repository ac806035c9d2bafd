#pragma once

#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/scene.hpp"
#include "stages/segment/objects.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The interaction of the hand with one recorded object, on the clock of the recording. An object
/// is represented by its bounding box along its own axes, or by a point if its size is unknown.
struct HandObjectInteraction {
  /// Name of the object.
  std::string object;
  /// [N] distance from the nearest fingertip that is seen [m]; if no fingertip is seen, from the
  /// wrist less the length of a hand; 0 inside, NaN if unseen.
  std::vector<double> distance;
  /// [N] true if within 0.1 s before and after, the wrist or index tip moves as if it were fixed to
  /// the object, within half of that displacement (of at least 2 mm).
  std::vector<bool> moves_with_hand;
  /// [N] true if the line from the thumb's tip to another tip passes through the object, which is
  /// no wider there than a hand can hold, and the tips are at its surface (25 mm each, since a tip
  /// is on the finger's axis).
  std::vector<bool> between_tips;
};

/// Returns one interaction for each object that has poses. Empty without signals.
std::vector<HandObjectInteraction> find_interactions(const HumanMotion& motion,
                                                     const HandSignals& signals,
                                                     const std::vector<SceneObject>& objects);

/// Returns the parts of the object motions that this hand caused: from the first to the last
/// instant at which the object moves with the hand, no farther than 0.1 m from it, if that lasts
/// for half of the motion or 0.1 s. Thus motions caused by the other hand are left out, and of a
/// handover the part before or after it. Of two objects that move together (a tray and an object on
/// it) only the one nearer to the fingertips is kept.
std::vector<ObjectMotion> motions_by_hand(const std::vector<ObjectMotion>& motions,
                                          const std::vector<HandObjectInteraction>& contacts,
                                          const HandSignals& signals);

/// Returns the object that is held longest between two instants; "" if no object is held for
/// `least_s`.
std::string longest_held_object(const std::vector<HandObjectInteraction>& contacts,
                                const HandSignals& signals, double from_s, double to_s,
                                double least_s);

}  // namespace morphe::segment
