#pragma once

#include <vector>

#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// Noise of one sensor with a given rms: a white part and a slow one (Ornstein-Uhlenbeck), which
/// has `slow_share` of the variance and is in its stationary state from the start.
struct NoiseLaw {
  double slow_share = 0.5, slow_s = 1, rate_hz = 240;
};
template <int N>
class SensorNoise {
 public:
  using Value = Eigen::Matrix<double, N, 1>;
  SensorNoise(const NoiseLaw& law, double rms, math::RandomStream& random)
      : kept_(std::exp(-1 / (law.slow_s * law.rate_hz))),
        added_(rms * std::sqrt(law.slow_share * (1 - kept_ * kept_))),
        white_(rms * std::sqrt(1 - law.slow_share)),
        random_(random) {
    for (double& value : slow_) value = rms * std::sqrt(law.slow_share) * random_.normal();
  }
  Value next() {
    Value noise;
    for (int k = 0; k < N; ++k) {
      slow_[k] = kept_ * slow_[k] + added_ * random_.normal();
      noise[k] = slow_[k] + white_ * random_.normal();
    }
    return noise;
  }

 private:
  double kept_, added_, white_;
  math::RandomStream& random_;
  Value slow_;
};

/// Samples [count] that were lost: bursts with lengths drawn from `burst_s`, the time between them
/// exponential with the mean that makes `share` of the time lost on average.
std::vector<bool> draw_dropouts(std::size_t count, double rate_hz, double share,
                                const FromTo& burst_s, math::RandomStream& random);

}  // namespace morphe::synthesize
