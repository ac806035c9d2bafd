#pragma once

#include <vector>

#include "pipeline/synthesize/script.hpp"

namespace morphe::synthesize {

/// The ground truth at the instants i / rate_hz of the sensors, over the whole script.
struct MotionSamples {
  /// The sample rate [Hz].
  double rate_hz = 240;
  /// The arm at each sample [N].
  std::vector<ArmSample> arm;
  /// The hand at each sample [N].
  std::vector<HandState> hand;
  /// The fingertips [N, 5] in the world frame [m].
  Array2D<Vec3> tip;
  /// The positions of the index tip without tremor [N] [m].
  std::vector<Vec3> index_without_tremor;
  /// The distances of thumb and index tip [N] [m].
  std::vector<double> aperture;

  /// Returns the time of sample i [s].
  double time(std::size_t i) const { return static_cast<double>(i) / rate_hz; }
  /// Returns the number of samples N.
  std::size_t size() const { return arm.size(); }
};
/// Samples the motion of a script.
MotionSamples sample_motion(const Subject& subject, const Script& script, double rate_hz);

}  // namespace morphe::synthesize
