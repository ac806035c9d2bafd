#include "stages/retime/squared_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/joint_spline.hpp"
#include "stages/retime/constants.hpp"

namespace morphe::retime {
namespace {

double duration_between(const SquaredVelocity& progress, double from, double to) {
  constexpr std::array<double, 5> node{
      -0.906179845938663992797626878299, -0.538469310105683091036314420700, 0,
      0.538469310105683091036314420700, 0.906179845938663992797626878299};
  constexpr std::array<double, 5> weight{
      0.236926885056189087514264040720, 0.478628670499366468041291514836,
      0.568888888888888888888888888889, 0.478628670499366468041291514836,
      0.236926885056189087514264040720};
  const double half = 0.5 * (to - from), middle = 0.5 * (to + from);
  double sum = 0;
  for (std::size_t k = 0; k < node.size(); ++k)
    sum += weight[k] / std::sqrt(squared_velocity_at(progress, middle + half * node[k]));
  return half * sum;
}

}  // namespace

RampedParameter ramp_ends(double clock_length, double ramp_s) {
  // A ramp covers 0.6 of its length in the path parameter.
  const double ramp = std::min(ramp_s, clock_length / 1.2);
  return {ramp, clock_length + 0.8 * ramp};
}

ParameterDerivatives clock_at(const RampedParameter& clock, double w) {
  const bool ending = w > 0.5 * clock.length;
  const double from_end = ending ? clock.length - w : w;
  const double z = from_end / clock.ramp;
  ParameterDerivatives g{from_end - 0.4 * clock.ramp, 1, 0, 0};
  if (z < 1) {
    g.u = clock.ramp * z * z * z * (2 - 2 * z + 0.6 * z * z);
    g.d1 = z * z * (6 - 8 * z + 3 * z * z);
    g.d2 = 12 * z * (1 - z) * (1 - z) / clock.ramp;
    g.d3 = 12 * (1 - z) * (1 - 3 * z) / (clock.ramp * clock.ramp);
  }
  if (ending) {
    g.u = clock.length - 0.8 * clock.ramp - g.u;
    g.d2 = -g.d2;
  }
  return g;
}

void apply_chain_rule(const ParameterDerivatives& g, JointRows& q) {
  q.row(3) = q.row(3) * (g.d1 * g.d1 * g.d1) + q.row(2) * (3 * g.d1 * g.d2) + q.row(1) * g.d3;
  q.row(2) = q.row(2) * (g.d1 * g.d1) + q.row(1) * g.d2;
  q.row(1) *= g.d1;
}

double squared_velocity_at(const SquaredVelocity& progress, double w) {
  const Eigen::Index intervals = progress.coefficient.size() - 3;
  const double knots = std::clamp(w / progress.length, 0.0, 1.0) * static_cast<double>(intervals);
  const auto interval = std::min(static_cast<Eigen::Index>(knots), intervals - 1);
  const auto weights = math::bspline_weights<3>(knots - static_cast<double>(interval));
  return progress.coefficient.segment<4>(interval).dot(
      Eigen::Map<const Eigen::Vector4d>(weights.data()));
}

SplineLaw spline_law(const RampedParameter& clock, SquaredVelocity progress) {
  const Eigen::Index cells = kCellsPerKnot * (progress.coefficient.size() - 3);
  SplineLaw law{clock, std::move(progress), clock.length / static_cast<double>(cells), {0}};
  for (Eigen::Index i = 0; i < cells; ++i) {
    const double from = static_cast<double>(i) * law.cell;
    law.time.push_back(law.time.back() + duration_between(law.square, from, from + law.cell));
  }
  return law;
}

double clock_at(const SplineLaw& law, double time_s) {
  if (!(time_s > 0)) return 0;
  const auto after = std::ranges::upper_bound(law.time, time_s);
  if (after == law.time.end()) return clock_at(law.clock, law.clock.length).u;
  const auto i = after - law.time.begin() - 1;
  const double from = static_cast<double>(i) * law.cell;
  double w = from + law.cell * (time_s - law.time[i]) / (law.time[i + 1] - law.time[i]);
  for (int step = 0; step < kMaxInversionSteps; ++step) {
    const double error_s = time_s - law.time[i] - duration_between(law.square, from, w);
    const double move = error_s * std::sqrt(squared_velocity_at(law.square, w));
    w = std::clamp(w + move, from, from + law.cell);
    if (std::abs(move) < kInversionTolerance * law.cell) break;
  }
  return clock_at(law.clock, w).u;
}

}  // namespace morphe::retime
