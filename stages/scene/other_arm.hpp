#pragma once

#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Returns the person's other arm as moving capsules, "other upper arm", "other forearm" and "other
/// hand", with the radii given by the options. In every frame, a capsule is aligned with the line
/// between the joints at its two ends and centred on their midpoint. Its length is the median
/// length of the bone; a longer bone in a single frame is covered by the caps. A hand ends at the
/// mean of the fingertips that are seen (without the thumb if there is another). If no fingertip is
/// seen, it extends from the wrist along the hand's orientation, or along the forearm if that is
/// unknown, by the median length (or 0.74 forearms, Drillis and Contini 1966). Frames in which an
/// end was not seen are left out, so that an object's pose is interpolated linearly across them.
/// `notes` gets a sentence for each part that is missing, estimated or seen for a part of the time.
std::vector<SceneObject> other_arm_capsules(const SceneOptions& options, const HumanMotion& other,
                                            std::vector<std::string>& notes);

/// Returns true if an object of that name is a part of the other arm under these options.
bool is_other_arm_part(const SceneOptions& options, const std::string& name);

}  // namespace morphe::scene
