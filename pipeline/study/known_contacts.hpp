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
  int finger = kThumb;
  Vec3 point = unknown_point();         ///< point of the surface, tip + pad depth * normal [m]
  Vec3 normal = unknown_point();        ///< unit normal, pointing inwards
  Vec3 tip = unknown_point();           ///< person's fingertip, on the finger's axis [m]
  Vec3 middle_joint = unknown_point();  ///< middle joint of that finger [m]
};

/// The fingers of a person at one instant, in any frame.
struct ObservedHand {
  std::array<Vec3, kFingerCount> tip, middle_joint;  ///< [m]
};

/// Returns the instant at which a person's hand is evaluated: the middle of the first phase
/// `grasp`; NaN if there is no such phase.
double grasp_instant_s(const std::vector<Phase>& phases);

/// Returns the contacts of a hand with a recorded sphere at an instant; other shapes have no
/// contacts, nor has the instant NaN. A finger touches at the point of the surface nearest to its
/// tip, if its skin (pad_depth_m from the tip) is within touch_distance_m of the surface. The hand
/// is given in the frame of the object's recorded poses.
std::vector<KnownContact> recorded_contacts(const SceneObject& object, double time_s,
                                            const ObservedHand& hand,
                                            const grasp::GraspOptions& options);

}  // namespace morphe::study
