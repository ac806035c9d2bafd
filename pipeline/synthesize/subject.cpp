#include "pipeline/synthesize/subject.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morphe::synthesize {
namespace {

constexpr double kMaxDeviate = 4;

/// Returns z with Φ(z) = percentile / 100.
double normal_quantile(double percentile) {
  double low = -kMaxDeviate, high = kMaxDeviate;
  for (int halving = 0; halving < 40; ++halving) {
    const double z = 0.5 * (low + high);
    (50 * std::erfc(-z / std::numbers::sqrt2) < percentile ? low : high) = z;
  }
  return 0.5 * (low + high);
}

}  // namespace

Subject draw_subject(const SyntheticSubject& o, math::RandomStream& random) {
  const human::Sex sex = random.bernoulli(o.male_share) ? human::Sex::male : human::Sex::female;
  const double min_deviate = normal_quantile(o.percentiles[0]);
  const double max_deviate = normal_quantile(o.percentiles[1]);
  std::array<double, 5> deviates{};
  for (double& z : deviates) z = normal_quantile(random.uniform(o.percentiles));
  for (int k = 1; k < std::ssize(deviates); ++k)
    deviates[k] = std::clamp(0.8 * deviates[0] + 0.6 * deviates[k], min_deviate, max_deviate);
  Subject subject;
  subject.body = human::anthropometry(sex, deviates);
  subject.hand = human::human_hand(subject.body.hand);
  subject.postures = draw_hand_postures(subject.hand, random);
  constexpr double kShoulderHalfBreadthShare = 0.1;  // of stature, from the middle to the joint
  subject.shoulder = {kShoulderHalfBreadthShare * subject.body.stature_m,
                      random.uniform(-0.18, -0.08), random.uniform(o.shoulder_height)};
  return subject;
}

}  // namespace morphe::synthesize
