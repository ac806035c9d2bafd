#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// One hand over a clip, in the world.
struct RecordedHand {
  Table<Vec3> joint;               ///< [N, 21] keypoints [m], NaN = not seen
  std::vector<Quat> turned;        ///< [N] world_from_hand as HumanMotion says, or none
  std::vector<double> confidence;  ///< [N] 0 to 1, or none
};

/// Hands and objects in one world (X right, Y forward, Z up) [m], on one clock: what trackers of
/// hands record, whatever their file looks like.
struct HandClip {
  std::vector<double> time;                          ///< [N] [s]
  std::array<std::optional<RecordedHand>, 2> hands;  ///< by Side
  BodyStream body;                                   ///< shoulders, elbows, head, if any, on `time`
  std::vector<SceneObject> objects;
  bool rebuilt = false;  ///< as BodyStream's
};

/// What Morphe calls a hand's keypoints: "right_wrist", "right_thumb_cmc", …
std::vector<std::string> keypoint_names(Side side);

/// Puts a clip into a demonstration: a skeleton with the joints of both hands that were ever seen
/// and those of the body, in Morphe's names, and the objects. The body may name parents.
void add_clip(HandClip&& clip, Demonstration& demonstration);

}  // namespace morphe::imports
