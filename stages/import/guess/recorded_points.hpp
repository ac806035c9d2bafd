#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// The points of a recording, whatever stream they are in.
struct RecordedPoints {
  std::vector<std::string> names;
  std::vector<std::string> parts;    ///< what each is taken for: body_part, or "head", "pelvis",
                                     ///< "right toe", …, by the words in its name; "" = unknown
  std::vector<std::string> parents;  ///< of a skeleton, otherwise empty
  std::vector<double> time;          ///< [N] [s]
  Table<Vec3> position;              ///< [N, K]
};

/// Markers, and the joints of a skeleton behind them; otherwise sensors or the points of a hand. No
/// names where it holds none.
RecordedPoints recorded_points(const Streams& streams, Side hand);

/// In each frame the mean of the points whose part begins so ("right elbow": both epicondyles,
/// too); unseen where none was.
std::vector<Vec3> mean_track(const RecordedPoints& points, std::string_view part);

/// Mean of what was seen; unseen if nothing was.
Vec3 mean_of(const std::vector<Vec3>& track);

}  // namespace morphe::imports
