#pragma once

#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// The parameters of a sensor's noise with a given rms: a white component and a slow one
/// (Ornstein-Uhlenbeck), which has the share `slow_share` of the variance and is stationary from
/// the start.
struct NoiseModel {
  /// The share and the time constant [s] of the slow component, and the sample rate [Hz].
  double correlated_noise_share = 0.5, correlation_time_s = 1, rate_hz = 240;
};
/// A generator of noise for N channels of one sensor.
template <int N>
class SensorNoise {
 public:
  /// The noise of all channels.
  using Value = Eigen::Matrix<double, N, 1>;
  /// Starts the generator in the stationary state.
  SensorNoise(const NoiseModel& law, double rms, math::RandomStream& random)
      : decay_(std::exp(-1 / (law.correlation_time_s * law.rate_hz))),
        innovation_(rms * std::sqrt(law.correlated_noise_share * (1 - decay_ * decay_))),
        white_(rms * std::sqrt(1 - law.correlated_noise_share)),
        random_(random) {
    for (double& value : correlated_)
      value = rms * std::sqrt(law.correlated_noise_share) * random_.normal();
  }
  /// Draws the noise of the next sample.
  Value next() {
    Value noise;
    for (int k = 0; k < N; ++k) {
      correlated_[k] = decay_ * correlated_[k] + innovation_ * random_.normal();
      noise[k] = correlated_[k] + white_ * random_.normal();
    }
    return noise;
  }

 private:
  double decay_, innovation_, white_;
  math::RandomStream& random_;
  Value correlated_;
};

/// Draws lost samples [count]: bursts with lengths drawn from `burst_s`; the time between them is
/// exponentially distributed with the mean for which `share` of the time is lost on average.
std::vector<bool> draw_dropouts(std::size_t count, double rate_hz, double share,
                                const UniformRange& burst_s, math::RandomStream& random);

}  // namespace morphe::synthesize
