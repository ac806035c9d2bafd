#include "stages/export/lerobot/frame_statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/math/random_stream.hpp"

namespace morphe::exports {
namespace {

TEST(FrameStatistics, AreThoseOfNumPy) {
  JointRows rows(5, 2);
  rows << 3, 1, 1, 1, 4, 1, 1, 1, 5, 1;
  const FrameStatistics own = statistics_of(rows);
  // numpy.quantile([3, 1, 4, 1, 5], [0.01, 0.1, 0.5, 0.9, 0.99]), .mean(), .std()
  EXPECT_EQ(own.count, 5);
  EXPECT_EQ(own.min[0], 1);
  EXPECT_EQ(own.max[0], 5);
  EXPECT_DOUBLE_EQ(own.mean[0], 2.8);
  EXPECT_DOUBLE_EQ(own.std[0], 1.6);
  const double expected[] = {1, 1, 3, 4.6, 4.96};
  for (int q = 0; q < 5; ++q) {
    EXPECT_DOUBLE_EQ(own.quantiles[q][0], expected[q]);
    EXPECT_EQ(own.quantiles[q][1], 1);
  }
}

void expect_near_exact(const std::vector<double>& values) {
  JointRows rows(std::ssize(values), 1);
  std::ranges::copy(values, rows.col(0).begin());
  RunningStatistics running(1);
  running.add(rows.topRows(rows.rows() / 3));
  running.add(rows.bottomRows(rows.rows() - rows.rows() / 3));
  const FrameStatistics exact = statistics_of(rows), own = running.statistics();
  const double range = exact.max[0] - exact.min[0];
  EXPECT_EQ(own.count, exact.count);
  EXPECT_EQ(own.min, exact.min);
  EXPECT_EQ(own.max, exact.max);
  EXPECT_NEAR(own.mean[0], exact.mean[0], 1e-9 * range);
  EXPECT_NEAR(own.std[0], exact.std[0], 1e-9 * range);
  for (int q = 0; q < 5; ++q)
    EXPECT_NEAR(own.quantiles[q][0], exact.quantiles[q][0], range / 500) << q;
}

TEST(RunningDistribution, IsNearTheExactOne) {
  math::RandomStream random(1, "distributions");
  const std::function<double()> draws[] = {
      [&] { return random.uniform(-2, 5); },          [&] { return random.normal(); },
      [&] { return 1000 + 1e-3 * random.normal(); },  [&] { return std::exp(3 * random.normal()); },
      [&] { return -std::exp(3 * random.normal()); },
  };
  for (const auto& draw : draws)
    for (int round = 0; round < 20; ++round) {
      std::vector<double> values(static_cast<std::size_t>(random.uniform(3, 4000)));
      std::ranges::generate(values, draw);
      expect_near_exact(values);
    }
}

TEST(RunningDistribution, IsExactForFewDistinctNumbers) {
  for (const double first : {0.0, -3.5, 12.0}) {
    RunningDistribution own;
    for (int k = 0; k < 100; ++k) own.add(k % 10 == 0 ? first : 7);
    EXPECT_EQ(own.quantile(0.5), 7);
    EXPECT_EQ(own.quantile(0), std::min(first, 7.0));
    EXPECT_EQ(own.quantile(1), std::max(first, 7.0));
  }
}

TEST(RunningDistribution, WidensInBothDirections) {
  std::vector<double> values;
  for (int k = 0; k < 200; ++k) values.push_back(std::pow(-1.2, k));
  expect_near_exact(values);
}

}  // namespace
}  // namespace morphe::exports
