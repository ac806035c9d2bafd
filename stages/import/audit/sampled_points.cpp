#include "stages/import/audit/sampled_points.hpp"

#include <algorithm>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {

std::size_t sample_step(std::size_t frames) {
  return std::max<std::size_t>(1, frames / kMedianFrames);
}

RecordedPoints sampled_points(const Streams& streams, Side hand) {
  const RecordedPoints points = recorded_points(streams, hand);
  const std::size_t step = sample_step(points.time.size());
  RecordedPoints sampled{points.names, points.parts, points.parents, {}, {}};
  sampled.position.cols = points.position.cols;
  for (std::size_t i = 0; i < points.time.size(); i += step) {
    const auto row =
        points.position.values.begin() + static_cast<std::ptrdiff_t>(i * points.position.cols);
    sampled.time.push_back(points.time[i]);
    sampled.position.values.insert(sampled.position.values.end(), row,
                                   row + static_cast<std::ptrdiff_t>(points.position.cols));
    ++sampled.position.rows;
  }
  return sampled;
}

}  // namespace morphe::imports
