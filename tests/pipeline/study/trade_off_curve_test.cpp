#include "pipeline/study/trade_off_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::study {
namespace {

constexpr double kUnitDirection_rad = 3 * kRadPerDegree;

/// Three movements whose palm gains a unit at each value, and whose other figures stay.
TradeOffCurve improving_palm() {
  TradeOffCurve curve;
  for (int k = 0; k < 4; ++k) {
    TradeOffPoint& point = curve.emplace_back(TradeOffPoint{0.1 * k, 3, 1, {}});
    point.movements.assign(3, {1.2 - k * kUnitDirection_rad, 0.2, 0.3, 1.3, 0.9, 0.002, 0.001});
  }
  return curve;
}

void add(double loss, int figure, TradeOffPoint& point) {
  for (TradeOffValues& movement : point.movements) movement[figure] += loss;
}

TEST(TradeOffKnee, IsTheLargestValueIfNothingIsLost) {
  const TradeOffCurve curve = improving_palm();
  EXPECT_NEAR(loss_of(curve, 3), -3, 1e-12);
  EXPECT_EQ(knee_of(curve), 3u);
}

TEST(TradeOffKnee, LiesBeforeTheValueThatLosesMoreThanItGains) {
  for (const auto& [figure, unit] :
       {std::pair(kDurationFigure, 0.05 * 1.3), std::pair(kSpeedFigure, -0.05),
        std::pair(kUpperArmFigure, kUnitDirection_rad)}) {
    TradeOffCurve curve = improving_palm();
    add(0.9 * unit, figure, curve[3]);
    EXPECT_EQ(knee_of(curve), 3u) << figure;
    add(0.2 * unit, figure, curve[3]);
    EXPECT_EQ(knee_of(curve), 2u) << figure;
  }
}

TEST(TradeOffKnee, ClearanceAndTipsDoNotCount) {
  TradeOffCurve curve = improving_palm();
  add(0.1, 6, curve[3]);
  EXPECT_NEAR(loss_of(curve, 3), -3, 1e-12);
}

TEST(TradeOffKnee, ComparesEachMovementWithItself) {
  TradeOffCurve curve = improving_palm();
  // A slow movement that fails at the least value, and a quick one that fails at the largest.
  curve[0].movements[0].fill(kUnknown);
  curve[3].movements[2].fill(kUnknown);
  for (TradeOffPoint& point : curve) point.movements[0][kDurationFigure] *= 2;
  EXPECT_NEAR(loss_of(curve, 3), -3, 1e-12);
}

TEST(TradeOffKnee, HasAsManyExecutableMovementsAsTheLeastValue) {
  TradeOffCurve curve = improving_palm();
  curve[1].executable = curve[3].executable = 2;
  EXPECT_EQ(knee_of(curve), 2u);
  curve[2].executable = 2;
  EXPECT_EQ(knee_of(curve), 0u);
}

TEST(TradeOffKnee, IsTheLeastValueIfNoMovementIsExecutable) {
  TradeOffCurve curve = improving_palm();
  for (TradeOffPoint& point : curve)
    for (TradeOffValues& movement : point.movements) movement.fill(kUnknown);
  EXPECT_TRUE(std::isnan(loss_of(curve, 1)));
  EXPECT_EQ(knee_of(curve), 0u);
}

TEST(TradeOffKnee, OfAllRobotsIsNotBeyondThatOfHalf) {
  EXPECT_EQ(common_knee({0.64, 0.08, 0.16}), 0.16);
  EXPECT_EQ(common_knee({0.64, 0.08, 0.16, 0.32}), 0.16);
}

TEST(TradeOffPoint, CountsAllMovementsAndTakesMediansOfTheExecutableOnes) {
  std::vector<Plan> plans(4);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    plans[k].reason = Reason::none;
    plans[k].certificate.duration_ratio = 1.0 + static_cast<double>(k);
  }
  plans[1].repaired = true;
  plans[3].reason = Reason::no_path;
  const TradeOffPoint point = point_of(0.16, plans);
  ASSERT_EQ(point.movements.size(), 4u);
  EXPECT_EQ(point.executable, 3);
  EXPECT_EQ(point.repaired, 1);
  EXPECT_EQ(point.median(kDurationFigure), 2);
  EXPECT_TRUE(std::isnan(point.median(kPalmFigure)));
}

}  // namespace
}  // namespace morphe::study
