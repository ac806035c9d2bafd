#pragma once

#include <array>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::study {

/// A contact of a person's finger with an object, in the object's frame.
struct KnownContact {
  /// The index of the finger.
  std::size_t finger = kThumb;
  /// Point of the surface, tip + pad depth * normal [m].
  Vec3 point = unknown_point();
  /// Unit normal, pointing inwards.
  Vec3 normal = unknown_point();
  /// The person's fingertip, on the finger's axis [m].
  Vec3 tip = unknown_point();
  /// Middle joint of that finger [m].
  Vec3 middle_joint = unknown_point();
};

/// The fingers of a person at one instant, in any frame.
struct ObservedHand {
  /// The fingertips and middle joints [m].
  std::array<Vec3, kFingerCount> tip, middle_joint;
};

/// Returns the instant at which both variants of the study evaluate a person's hand: the middle of
/// the first phase `grasp`, NaN if there is no such phase.
double grasp_instant_s(const std::vector<Phase>& phases);

/// Returns the contacts of a recording whose object was recorded. A finger touches at the point of
/// the surface nearest to its tip at that instant, if its skin (pad_depth from the tip) is within
/// `near` of the surface. The hand is given in the frame of the object's recorded poses. Returns an
/// empty list for shapes other than spheres.
std::vector<KnownContact> recorded_contacts(const SceneObject& object, double time_s,
                                            const ObservedHand& hand,
                                            const grasp::GraspOptions& options);

}  // namespace morphe::study
