#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// The track of one hand over a clip, in the world.
struct RecordedHand {
  Array2D<Vec3> keypoints;         ///< [N, 21] keypoints [m], NaN if not seen
  std::vector<Quat> orientation;   ///< [N] world_from_hand as in HumanMotion, or empty
  std::vector<double> confidence;  ///< [N] 0 to 1, or empty
};

/// Hands and objects in one world (X right, Y forward, Z up) [m], on one clock: the data of hand
/// trackers, independent of their file formats.
struct HandClip {
  std::vector<double> time;                          ///< [N] [s]
  std::array<std::optional<RecordedHand>, 2> hands;  ///< by Side
  BodyStream body;                                   ///< shoulders, elbows, head, if any, on `time`
  std::vector<SceneObject> objects;                  ///< with their motion
  bool reconstructed = false;                        ///< as BodyStream::rebuilt
};

/// Returns Morphe's names of a hand's keypoints: "right_wrist", "right_thumb_cmc", …
std::vector<std::string> keypoint_names(Side side);

/// Adds a clip to a demonstration: a skeleton with the joints of both hands that were ever seen and
/// those of the body, with Morphe's names, and the objects. The body may name parents.
void add_clip(HandClip&& clip, Demonstration& demonstration);

}  // namespace morphe::imports
