#pragma once

#include <string>
#include <vector>

#include "stages/import/trackers/hand_clip.hpp"

namespace morphe::imports {

/// Hides the points by which programs write that they saw no hand, and reports them: joints of a
/// hand that are all at one point, and joints of hands and body exactly at the origin, unless a
/// joint is there in every frame in which it was seen.
void hide_unseen_points(HandClip& clip, std::vector<std::string>& reports);

/// Does so for one hand, `whose` ("right hand"), with the keypoints [N, 21].
void hide_unseen_points(const std::string& whose, Array2D<Vec3>& keypoints,
                        std::vector<std::string>& reports);

/// Returns true if the wrist is the origin in every frame in which it was seen, but other joints
/// are not: the joints are in the frame of the hand.
bool is_wrist_at_origin(const RecordedHand& hand);

}  // namespace morphe::imports
