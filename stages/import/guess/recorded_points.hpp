#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// The points of a recording, from any of its streams.
struct RecordedPoints {
  std::vector<std::string> names;  ///< [K] recorded names
  /// [K] parts of the body by the words in the names: body_part(), "head", "right toe", … or "".
  std::vector<std::string> parts;
  std::vector<std::string> parents;  ///< [K] names, "" for markers; empty without a skeleton
  std::vector<double> time;          ///< [N] [s]
  Array2D<Vec3> position;            ///< [N, K]
};

/// Returns the names of the points of a hand stream of keypoints or fingertips: "right_thumb_tip".
std::vector<std::string> hand_point_names(HandKind kind, const std::string& side);

/// Returns the markers and, if its times are the same, the joints of the skeleton; without them,
/// the sensors with a hand's fingertips, or the points of a hand. `hand` is their side.
RecordedPoints recorded_points(const Streams& streams, Side hand);

/// Returns the names of a hand's points: "right_wrist", "right_thumb_cmc", … "right_little_tip" of
/// keypoints, and those of the five tips of any other kind. `side` is "right" or "left".
std::vector<std::string> hand_point_names(HandKind kind, const std::string& side);

/// Returns in each frame the mean of the seen points whose part has this prefix ("right elbow"
/// includes both epicondyles), or an unseen point.
std::vector<Vec3> mean_track(const RecordedPoints& points, std::string_view part_prefix);

/// Returns the mean of the seen points; unseen if there are none.
Vec3 mean_of(const std::vector<Vec3>& points);
/// Returns the sum of (p - mean) (p - mean)ᵀ over the seen points p.
Eigen::Matrix3d scatter_of(const std::vector<Vec3>& points);

}  // namespace morphe::imports
