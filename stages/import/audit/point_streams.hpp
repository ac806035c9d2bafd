#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// A stream that holds positions.
enum class PointStreamKind : std::uint8_t { markers, sensors, skeleton, hand };

/// The points of one stream, as they were recorded. Refers to the recording.
struct PointStream {
  PointStreamKind kind = PointStreamKind::markers;
  std::vector<std::string> names;   ///< [K]
  std::vector<bool> other_side;     ///< [K] true for points of the arm that does not reach
  const std::vector<double>& time;  ///< [N] [s]
  const Array2D<Vec3>& position;    ///< [N, K] [m]
};

/// Returns the streams of a recording that hold positions.
std::vector<PointStream> point_streams(const Demonstration& recording);

/// Returns the median time between rows; NaN with fewer than two [s].
double median_period(const std::vector<double>& time);

/// A point that is hidden in rows of its stream.
struct HiddenRows {
  PointStreamKind kind = PointStreamKind::markers;
  std::size_t point = 0;
  std::size_t begin = 0, end = 0;  ///< first row, and the row after the last one
};

/// Sets positions, and the orientations that belong to them, to unseen.
void hide(const std::vector<HiddenRows>& hidden, Streams& streams);

}  // namespace morphe::imports
