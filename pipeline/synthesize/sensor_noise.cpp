#include "pipeline/synthesize/sensor_noise.hpp"

#include <cmath>

namespace morphe::synthesize {

std::vector<bool> draw_dropouts(std::ptrdiff_t count, double rate_hz, double share,
                                const UniformRange& burst_s, math::RandomStream& random) {
  std::vector<bool> lost(count, false);
  if (share <= 0) return lost;
  const double mean_burst_s = 0.5 * (burst_s[0] + burst_s[1]);
  const double mean_between_s = mean_burst_s * (1 - share) / share;
  const auto between_s = [&] { return -mean_between_s * std::log(1 - random.uniform()); };
  // Starts before the recording, so that its first samples are distributed like the others.
  const double length_s = static_cast<double>(count) / rate_hz;
  double now_s = -burst_s[1] - between_s();
  while (now_s < length_s) {
    const double end_s = now_s + random.uniform(burst_s);
    const auto first = std::lround(std::max(0.0, std::ceil(now_s * rate_hz)));
    for (auto i = first; i < count && static_cast<double>(i) < end_s * rate_hz; ++i) lost[i] = true;
    now_s = end_s + between_s();
  }
  return lost;
}

}  // namespace morphe::synthesize
