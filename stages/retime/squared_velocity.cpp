#include "stages/retime/squared_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/joint_spline.hpp"

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
  for (std::size_t k = 0; k < node.size(); ++k) {
    sum += weight[k] / std::sqrt(squared_velocity_at(progress, middle + half * node[k]));
  }
  return half * sum;
}

}  // namespace

double squared_velocity_at(const SquaredVelocity& progress, double w) {
  const Eigen::Index intervals = progress.coefficient.size() - 3;
  const double knots = std::clamp(w / progress.length, 0.0, 1.0) * static_cast<double>(intervals);
  const auto interval = std::min(static_cast<Eigen::Index>(knots), intervals - 1);
  const auto weights = math::bspline_weights<3>(knots - static_cast<double>(interval));
  return progress.coefficient.segment<4>(interval).dot(
      Eigen::Map<const Eigen::Vector4d>(weights.data()));
}

SplineLaw spline_law(const RampedParameter& clock, SquaredVelocity progress) {
  constexpr Eigen::Index kCellsPerKnot = 4;
  const Eigen::Index cells = kCellsPerKnot * (progress.coefficient.size() - 3);
  SplineLaw law{clock, std::move(progress), clock.length / static_cast<double>(cells), {0}};
  for (Eigen::Index i = 0; i < cells; ++i) {
    const double from = static_cast<double>(i) * law.cell;
    law.time.push_back(law.time.back() +
                       duration_between(law.squared_velocity, from, from + law.cell));
  }
  return law;
}

double clock_at(const SplineLaw& law, double time_s) {
  if (!(time_s > 0)) return 0;
  const auto after = std::upper_bound(law.time.begin(), law.time.end(), time_s);
  if (after == law.time.end()) return clock_at(law.clock, law.clock.length).u;
  const auto i = static_cast<std::size_t>(after - law.time.begin()) - 1;
  // relative to a cell; the remaining error is its square
  constexpr double kConvergenceTolerance = 1e-8;
  const double from = static_cast<double>(i) * law.cell;
  double w = from + law.cell * (time_s - law.time[i]) / (law.time[i + 1] - law.time[i]);
  for (int step = 0; step < 8; ++step) {
    const double off = time_s - law.time[i] - duration_between(law.squared_velocity, from, w);
    const double move = off * std::sqrt(squared_velocity_at(law.squared_velocity, w));
    w = std::clamp(w + move, from, from + law.cell);
    if (std::abs(move) < kConvergenceTolerance * law.cell) break;
  }
  return clock_at(law.clock, w).u;
}

}  // namespace morphe::retime
