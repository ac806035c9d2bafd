#pragma once

#include <vector>

#include "pipeline/synthesize/script.hpp"

namespace morphe::synthesize {

/// The true motion at the instants i / rate_hz of the sensors, over the whole script.
struct MotionSamples {
  double rate_hz = 240;
  std::vector<ArmSample> arm;              ///< [N] with drift and tremor
  std::vector<HandState> hand;             ///< [N]
  Array2D<Vec3> tip;                       ///< [N, 5] in the world frame [m]
  std::vector<Vec3> index_without_tremor;  ///< [N] tip of the index finger [m]
  std::vector<double> aperture;            ///< [N] distance of thumb and index tip [m]

  /// Returns the time of sample i [s].
  double time(std::ptrdiff_t i) const { return static_cast<double>(i) / rate_hz; }
  /// Returns N.
  std::ptrdiff_t size() const { return std::ssize(arm); }
};
/// Samples the motion of a script.
MotionSamples sample_motion(const Subject& subject, const Script& script, double rate_hz);

}  // namespace morphe::synthesize
