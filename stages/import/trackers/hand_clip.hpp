#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/trackers/keypoint_orders.hpp"

namespace morphe::imports {

/// The motion of one hand over a clip, in the world.
struct RecordedHand {
  Array2D<Vec3> keypoints;         ///< [N, 21] [m], NaN if not seen
  std::vector<Quat> orientation;   ///< [N] world_from_hand as in HumanMotion, or empty
  std::vector<double> confidence;  ///< [N] 0 to 1, or empty
};

/// Hands, body and objects in one world (X right, Y forward, Z up) [m], on one clock. Readers of
/// hand trackers fill it, whatever their file format.
struct HandClip {
  std::vector<double> time;                          ///< [N] [s]
  std::array<std::optional<RecordedHand>, 2> hands;  ///< by Side
  BodyStream body;  ///< shoulders, elbows, head, if any; its own `time` is not used
  std::vector<SceneObject> objects;  ///< with their motion
  bool reconstructed = false;        ///< as BodyStream::reconstructed
};

/// Returns the index of a side in an array by Side.
constexpr int side_index(Side side) { return side == Side::right ? 0 : 1; }

/// Returns the index of a name in a list, -1 if absent.
int name_index(const std::vector<std::string>& names, std::string_view name);

/// Returns Morphe's names of a hand's keypoints: "right_wrist", "right_thumb_cmc", …
std::vector<std::string> keypoint_names(Side side);

/// Returns true if any point or rotation of the range is known.
template <class Range>
bool any_known(const Range& values) {
  return std::ranges::any_of(values, [](const auto& value) { return is_known(value); });
}

/// Returns true if any point or rotation of the column is known.
template <class T>
bool any_known(const Array2D<T>& values, std::size_t column) {
  for (std::size_t row = 0; row < values.rows; ++row) {
    if (is_known(values(row, column))) return true;
  }
  return false;
}

/// Returns a body whose joints are unseen in `rows` frames, without times.
BodyStream unseen_body(std::vector<std::string> names, std::size_t rows);

/// Sets the pose of a joint in a frame.
void set_pose(const Pose& pose, std::size_t row, std::size_t joint, BodyStream& body);

/// Sets the demonstration's skeleton to the joints of the body and those of both hands that were
/// ever seen, with Morphe's names, and adds the objects. Only joints of the body have parents.
void add_clip(HandClip&& clip, Demonstration& demonstration);

}  // namespace morphe::imports
