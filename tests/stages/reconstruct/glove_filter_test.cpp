#include "stages/reconstruct/glove_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace morphe::reconstruct {
namespace {

using Columns = std::vector<std::vector<double>>;

constexpr std::size_t kColumns = 22;
constexpr double kRate = 90, kBegin_s = 4, kLength_s = 0.25, kLast_s = 8;
constexpr double kGloveNoise = 0.0123;  ///< [rad] the white part of one degree

double progress(double tau) {
  tau = std::clamp(tau, 0.0, 1.0);
  return tau * tau * tau * (10 + tau * (-15 + 6 * tau));
}

/// Rest, a fast closing of the first `moving` columns by 0.6 rad, rest.
double angle(std::size_t column, std::size_t moving, double time_s) {
  return column < moving ? 0.6 * progress((time_s - kBegin_s) / kLength_s) : 0.0;
}

struct Filtered {
  TimeGrid clock{0, 100, static_cast<int>(kLast_s * 100)};
  Columns fitted, plain;

  Filtered(std::size_t moving, double noise, double step = 0) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> time;
    Columns raw(kColumns);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(kLast_s * kRate); ++i) {
      time.push_back(static_cast<double>(i) / kRate);
      for (std::size_t k = 0; k < kColumns; ++k) {
        const double value = angle(k, moving, time.back()) + noise * normal(random);
        raw[k].push_back(step > 0 ? step * std::round(value / step) : value);
      }
    }
    const ReconstructOptions options;
    fitted = filter_glove(time, raw, clock, options);
    for (const std::vector<double>& column : raw) {
      plain.push_back(resample(time, column, clock, options));
    }
  }
  /// rms rate of change where the hand rests, of all columns.
  double jitter(const Columns& columns) const {
    double sum = 0, count = 0;
    for (const std::vector<double>& column : columns) {
      for (std::size_t i = 51; i + 50 < column.size(); ++i) {
        if (std::abs(clock.at(i) - kBegin_s) < 0.5) continue;
        const double rate = (column[i] - column[i - 1]) * clock.rate_hz;
        sum += rate * rate;
        ++count;
      }
    }
    return std::sqrt(sum / count);
  }
  /// rms error of a column while it closes.
  double error(const Columns& columns, std::size_t column, std::size_t moving) const {
    double sum = 0, count = 0;
    for (int i = 0; i < clock.count; ++i) {
      if (clock.at(i) < kBegin_s || clock.at(i) > kBegin_s + kLength_s) continue;
      sum += std::pow(columns[column][i] - angle(column, moving, clock.at(i)), 2);
      ++count;
    }
    return std::sqrt(sum / count);
  }
};

TEST(GloveFilter, AHandAtRestIsCalm) {
  const Filtered all(kColumns, kGloveNoise), none(0, kGloveNoise);
  EXPECT_LT(all.jitter(all.fitted), all.jitter(all.plain) / 3);
  EXPECT_LT(none.jitter(none.fitted), none.jitter(none.plain) / 3);
}

TEST(GloveFilter, AMovingHandIsAsFastAsTheLowPassLetsIt) {
  for (const std::size_t moving : {std::size_t{1}, kColumns}) {
    const Filtered hand(moving, kGloveNoise);
    const double error = hand.error(hand.fitted, 0, moving);
    EXPECT_LT(error, 1.1 * hand.error(hand.plain, 0, moving) + 0.001) << moving;
    const auto peak = [](const std::vector<double>& column) {
      double fastest = 0;
      for (std::size_t i = 350; i < 480; ++i) {
        fastest = std::max(fastest, column[i + 1] - column[i]);
      }
      return fastest;
    };
    EXPECT_NEAR(peak(hand.fitted[0]) / peak(hand.plain[0]), 1, 0.02) << moving;
  }
}

TEST(GloveFilter, WithoutNoiseNothingIsTakenAway) {
  const Filtered clean(kColumns, 0);
  for (int i = 0; i < clean.clock.count; ++i) {
    ASSERT_NEAR(clean.fitted[0][i], clean.plain[0][i], 1e-4) << i;
  }
  const Filtered steps(kColumns, 0, 0.0175);  // most samples repeat the one before
  EXPECT_EQ(steps.fitted, steps.plain);
}

}  // namespace
}  // namespace morphe::reconstruct
