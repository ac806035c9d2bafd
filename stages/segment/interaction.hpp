#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/task.hpp"
#include "stages/segment/constants.hpp"
#include "stages/segment/objects.hpp"
#include "stages/segment/segment_options.hpp"
#include "stages/segment/signals.hpp"

namespace morphe::segment {

/// The interaction of the hand with one recorded object, on the clock of the recording. An object
/// is represented by its bounding box along its own axes, or by a point if its size is unknown.
struct HandObjectInteraction {
  std::string object;  ///< its name
  /// [N] distance of the object from the nearest fingertip that is seen [m]; if no fingertip is
  /// seen, from the wrist less the length of a hand; 0 inside the object; NaN if all are unseen.
  std::vector<double> distance;
  /// [N] true if the wrist or the index tip moves like the object from 0.1 s before to 0.1 s after.
  /// Were it fixed to the object, it would be displaced by d > 2 mm; its displacement differs from
  /// that by less than |d| / 2.
  std::vector<bool> moves_with_hand;
  /// [N] true if the line from the thumb's tip to another tip passes through the object, which is
  /// no wider there than a hand can hold, and less than 50 mm of the line are outside of it (a tip
  /// is on the finger's axis).
  std::vector<bool> between_tips;
};

/// The data of a recording on one hand and the objects around it.
struct HandRecord {
  const HumanMotion& motion;
  const SegmentOptions& options;
  const std::vector<SceneObject>& objects;
  TaskKind task = TaskKind::unknown;  ///< as stated
  HandSignals signals;
  std::vector<HandObjectInteraction> interactions = {};
  std::vector<ObjectMotion> motions = {};  ///< caused by this hand
  Vec3 shoulder = unknown_point();         ///< median position; unknown if it was never seen
  double arm_length_m = kUnknown;          ///< upper arm and forearm
};

/// Returns one interaction for each object that has poses. Empty if `signals` is empty.
std::vector<HandObjectInteraction> find_interactions(const HumanMotion& motion,
                                                     const HandSignals& signals,
                                                     const std::vector<SceneObject>& objects);

/// Returns the parts of the object motions that this hand caused. A part extends from the first to
/// the last instant at which the object moves with the hand and is within 0.1 m of it; ends within
/// 0.2 s of the motion's own keep those. These instants must last for min(0.1 s, half the motion).
/// Thus motions caused by the other hand are left out, and of a handover the part before or after
/// it. Of two objects that move together (a tray and an object on it) only the one nearer to the
/// fingertips is kept. `displacement_m` remains that of the whole motion.
std::vector<ObjectMotion> motions_by_hand(const std::vector<ObjectMotion>& motions,
                                          const std::vector<HandObjectInteraction>& interactions,
                                          const HandSignals& signals);

/// Returns true if two intervals (begin_s, end_s) overlap by more than half of the shorter one.
template <class A, class B>
bool overlap_in_time(const A& a, const B& b) {
  const double common_s = std::min(a.end_s, b.end_s) - std::max(a.begin_s, b.begin_s);
  return common_s > kMinOverlapShare * std::min(a.end_s - a.begin_s, b.end_s - b.begin_s);
}

/// Returns the object that is between the tips for the longest total time from `from_s` to `to_s`,
/// the first of several; "" if there is none for at least `min_held_s`.
std::string longest_held_object(const std::vector<HandObjectInteraction>& interactions,
                                const HandSignals& signals, double from_s, double to_s,
                                double min_held_s);

}  // namespace morphe::segment
