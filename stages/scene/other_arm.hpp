#pragma once

#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// The person's other arm as moving capsules, "other upper arm", "other forearm" and "other hand",
/// of the radii that the options give. Each runs at every frame along the line between the joints
/// at its two ends, centred on their middle, as long as the bone in the median: what the bone is
/// longer by in a frame is within the caps. A hand ends in the middle of the fingertips that are
/// seen (without the thumb where there is another); where none is, it goes on from the wrist as the
/// hand is turned, else as the forearm does, as long as in the median (or 0.74 forearms, Drillis
/// and Contini 1966). Frames in which an end was not seen are left out, so that an object's pose
/// goes straight across them. `notes` gets a sentence for each part that is missing, estimated or
/// seen for a part of the time.
std::vector<SceneObject> other_arm_capsules(const SceneOptions& options, const HumanMotion& other,
                                            std::vector<std::string>& notes);

/// Whether these options make an object of that name a part of the other arm.
bool of_other_arm(const SceneOptions& options, const std::string& name);

}  // namespace morphe::scene
