#pragma once

#include <string>
#include <vector>

#include "core/motion/human_motion.hpp"
#include "stages/scene/scene_options.hpp"

namespace morphe::scene {

/// Returns the person's other arm as moving capsules, "other upper arm", "other forearm" and "other
/// hand", with the radii given by the options. In every frame, a capsule is aligned with the line
/// between the joints at its two ends and centred on their midpoint. Its length is the median
/// distance of these joints; in a frame in which they are farther apart, the caps cover up to a
/// radius more at each end. Frames in which an end was not seen are left out, so that the pose is
/// interpolated linearly across them.
///   The hand ends at the mean of the fingertips that are seen, without the thumb if there is
///   another. In a frame without fingertips, it extends from the wrist along the hand's
///   orientation; if that is unknown, along the forearm. Its length is then the median of the other
///   frames; without those, 0.74 forearms (Drillis and Contini 1966), or 0.18 m.
/// `notes` gets a sentence for each part that is missing, estimated or seen for a part of the time.
std::vector<SceneObject> other_arm_capsules(const SceneOptions& options, const HumanMotion& other,
                                            std::vector<std::string>& notes);

}  // namespace morphe::scene
