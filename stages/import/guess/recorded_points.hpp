#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// The points of a recording, from any of its streams.
struct RecordedPoints {
  std::vector<std::string> names;  ///< [K] recorded names
  /// Part of each point by the words in its name: body_part, or "head", "pelvis", "right toe", …;
  /// "" if unknown.
  std::vector<std::string> parts;
  std::vector<std::string> parents;  ///< for a skeleton, otherwise empty
  std::vector<double> time;          ///< [N] [s]
  Array2D<Vec3> position;            ///< [N, K]
};

/// Returns the markers, followed by the joints of a skeleton; otherwise sensors or the points of a
/// hand. It has no names if there are no points.
RecordedPoints recorded_points(const Streams& streams, Side hand);

/// Returns in each frame the mean of the points whose part has this prefix ("right elbow" includes
/// both epicondyles); unseen if no such point was seen.
std::vector<Vec3> mean_track(const RecordedPoints& points, std::string_view part);

/// Returns the mean of the seen points; unseen if there are no seen points.
Vec3 mean_of(const std::vector<Vec3>& track);

}  // namespace morphe::imports
