#pragma once

#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A sensor's noise: a slow component (stationary Ornstein-Uhlenbeck), which has
/// `correlated_noise_share` of the variance, and white noise.
struct NoiseModel {
  double correlated_noise_share = 0.5, correlation_time_s = 1, rate_hz = 240;
};
/// A generator of noise for N channels of one sensor.
template <int N>
class SensorNoise {
 public:
  using Value = Eigen::Matrix<double, N, 1>;
  /// Starts the generator in the stationary state. `random` must outlive it.
  SensorNoise(const NoiseModel& model, double rms, math::RandomStream& random)
      : decay_(std::exp(-1 / (model.correlation_time_s * model.rate_hz))),
        innovation_(rms * std::sqrt(model.correlated_noise_share * (1 - decay_ * decay_))),
        white_(rms * std::sqrt(1 - model.correlated_noise_share)),
        random_(random) {
    for (double& value : correlated_)
      value = rms * std::sqrt(model.correlated_noise_share) * random_.normal();
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

/// Returns [count] flags, true for lost samples. Samples are lost in bursts with a duration in
/// `burst_s` and exponentially distributed times between them; on average `share` of all is lost.
std::vector<bool> draw_dropouts(std::ptrdiff_t count, double rate_hz, double share,
                                const UniformRange& burst_s, math::RandomStream& random);

}  // namespace morphe::synthesize
