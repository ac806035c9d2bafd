#include "pipeline/study/trade_off_curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace morphe::study {
namespace {

constexpr double kDegreesPerRadian = 1 / kRadPerDegree;
/// Losses that count alike, chosen by hand: half of the 6 degrees by which two repetitions of one
/// person's movement differ, a twentieth of the time, and of a perfect correlation.
constexpr double kUnitDirection_rad = 3 * kRadPerDegree;
constexpr double kUnitDurationShare = 0.05, kUnitCorrelation = 0.05;

constexpr std::array<TradeOffFigure, kTradeOffFigureCount> kFigures{{
    {"palm angle to the human's, median", "rad", "palm [deg]", kDegreesPerRadian, 1,
     &Certificate::palm_error_mean, 1, kUnitDirection_rad},
    {"upper arm angle to the human's, median", "rad", "upper arm [deg]", kDegreesPerRadian, 1,
     &Certificate::upper_arm_error_mean, 1, kUnitDirection_rad},
    {"forearm angle to the human's, median", "rad", "forearm [deg]", kDegreesPerRadian, 1,
     &Certificate::forearm_error_mean, 1, kUnitDirection_rad},
    {"duration ratio, median", "1", "duration ratio", 1, 2, &Certificate::duration_ratio, 1, 0,
     kUnitDurationShare},
    {"wrist speed correlation, median", "1", "wrist speed r", 1, 2,
     &Certificate::wrist_speed_correlation, -1, kUnitCorrelation},
    {"clearance, median", "m", "clearance [mm]", kMillimetresPerMetre, 1, &Certificate::clearance,
     -1, kInfinity},
    {"tip error, mean, median", "m", "tips [mm]", kMillimetresPerMetre, 2,
     &Certificate::tip_error_mean, 1, kInfinity},
}};

/// Returns the sum of the losses of a movement in the figures' units; a figure that is unknown in
/// one of the points does not count.
double loss_of(const TradeOffValues& values, const TradeOffValues& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    const TradeOffFigure& figure = kFigures[i];
    const double unit = figure.unit_loss + figure.unit_share * std::abs(reference[i]);
    const double loss = figure.worse_sign * (values[i] - reference[i]) / unit;
    if (!std::isnan(loss)) sum += loss;
  }
  return sum;
}

bool is_known(const TradeOffValues& values) {
  return !std::ranges::all_of(values, [](double value) { return std::isnan(value); });
}

}  // namespace

const std::array<TradeOffFigure, kTradeOffFigureCount>& trade_off_figures() { return kFigures; }

double TradeOffPoint::median(int figure) const {
  std::vector<double> values;
  for (const TradeOffValues& movement : movements)
    if (!std::isnan(movement[figure])) values.push_back(movement[figure]);
  return math::midpoint_median(std::move(values));
}

TradeOffPoint point_of(double value, const std::vector<Plan>& plans) {
  TradeOffPoint point{value, 0, 0, {}};
  for (const Plan& plan : plans) {
    TradeOffValues& values = point.movements.emplace_back();
    values.fill(kUnknown);
    if (!plan.executable()) continue;
    ++point.executable;
    point.repaired += plan.repaired ? 1 : 0;
    for (std::size_t i = 0; i < kFigures.size(); ++i)
      values[i] = plan.certificate.*kFigures[i].figure;
  }
  return point;
}

double loss_of(const TradeOffCurve& curve, std::size_t point) {
  const std::vector<TradeOffValues>&first = curve.front().movements,
        &other = curve[point].movements;
  std::vector<double> losses;
  for (std::size_t k = 0; k < std::min(first.size(), other.size()); ++k)
    if (is_known(first[k]) && is_known(other[k])) losses.push_back(loss_of(other[k], first[k]));
  return math::midpoint_median(std::move(losses));
}

std::size_t knee_of(const TradeOffCurve& curve) {
  std::size_t knee = 0;
  double least = 0;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double loss = loss_of(curve, k);
    if (curve[k].executable < curve[0].executable || !(loss < least)) continue;
    least = loss;
    knee = k;
  }
  return knee;
}

double common_knee(const std::vector<double>& knees) { return math::lower_quantile(knees, 0.5); }

}  // namespace morphe::study
