#pragma once

#include <array>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/scene.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::study {

/// Where a person's finger touched an object: everything in the object's frame.
struct KnownContact {
  std::size_t finger = kThumb;
  Vec3 point = unseen_point();         ///< of the surface, tip + pad depth * normal [m]
  Vec3 normal = unseen_point();        ///< unit, inwards
  Vec3 tip = unseen_point();           ///< the person's fingertip, on the finger's axis [m]
  Vec3 middle_joint = unseen_point();  ///< of that finger [m]
};

/// A person's fingers at one instant, in any frame.
struct SeenHand {
  std::array<Vec3, kFingers> tip, middle_joint;
};

/// The instant at which both sides of the study look at a person's hand: the middle of the first
/// phase `grasp`, NaN without one.
double instant_of_grasp(const std::vector<Phase>& phases);

/// Contacts of a recording whose object was recorded: a finger touches where the surface is nearest
/// to its tip at that instant, if its skin (pad_depth from the tip) is within `near` of it. The
/// hand is in the frame of the object's recorded poses. None for shapes that are no sphere.
std::vector<KnownContact> recorded_contacts(const SceneObject& object, double time_s,
                                            const SeenHand& hand,
                                            const grasp::GraspOptions& options);

}  // namespace morphe::study
