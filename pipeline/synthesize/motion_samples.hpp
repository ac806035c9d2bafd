#pragma once

#include <vector>

#include "pipeline/synthesize/script.hpp"

namespace morphe::synthesize {

/// The truth at the sensors' instants i / rate_hz, over the whole script.
struct MotionSamples {
  double rate_hz = 240;
  std::vector<ArmAt> arm;          ///< [N]
  std::vector<HandState> hand;     ///< [N]
  Table<Vec3> tip;                 ///< [N, 5] in the world [m]
  std::vector<Vec3> steady_index;  ///< [N] the index tip as it were without tremor
  std::vector<double> aperture;    ///< [N] distance of thumb and index tip [m]

  double time(std::size_t i) const { return static_cast<double>(i) / rate_hz; }
  std::size_t size() const { return arm.size(); }
};
MotionSamples sample_motion(const Subject& subject, const Script& script, double rate_hz);

}  // namespace morphe::synthesize
