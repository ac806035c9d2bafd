#include "pipeline/synthesize/simulated_glove.hpp"

#include <cmath>

namespace morphe::synthesize {

GloveBias draw_bias(const SyntheticGlove& options, math::RandomStream& random) {
  GloveBias bias;
  for (double& sensor : bias) sensor = options.bias * random.normal();
  return bias;
}

HandStream simulate_glove(const SyntheticGlove& options, const GloveBias& bias,
                          const std::function<human::GloveAngles(double time_s)>& reading,
                          double length_s, double clock_offset_s, math::RandomStream& random) {
  constexpr int kSensors = human::kGloveSensorCount;
  HandStream stream;
  stream.kind = HandKind::glove;
  stream.names.assign(std::begin(human::kGloveSensors), std::end(human::kGloveSensors));
  const Eigen::Index count = std::lround(std::floor(length_s * options.rate_hz)) + 1;
  stream.angles.resize(count, kSensors);
  SensorNoise<kSensors> noise(
      {options.correlated_noise_share, options.correlation_time_s, options.rate_hz}, options.noise,
      random);
  for (int i = 0; i < count; ++i) {
    const double time_s = i / options.rate_hz;
    stream.time.push_back(time_s + clock_offset_s);
    const human::GloveAngles ideal = reading(time_s);
    GloveBias angles = Eigen::Map<const GloveBias>(ideal.data()) + bias + noise.next();
    if (options.quantisation > 0)
      angles = (angles / options.quantisation).array().round() * options.quantisation;
    stream.angles.row(i) = angles.transpose();
  }
  return stream;
}

void apply_dropouts(const SyntheticGlove& options, math::RandomStream& random, HandStream& glove) {
  const std::vector<bool> lost = draw_dropouts(glove.time.size(), options.rate_hz,
                                               options.dropout_share, options.dropout_s, random);
  for (int i = 0; i < std::ssize(lost); ++i)
    if (lost[i]) glove.angles.row(i).setConstant(kUnknown);
}

}  // namespace morphe::synthesize
