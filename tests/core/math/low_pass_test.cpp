#include "core/math/low_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morphe::math {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

std::vector<double> sine(double frequency_hz, double rate_hz, std::size_t count, double phase) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(std::sin(kTwoPi * frequency_hz * static_cast<double>(i) / rate_hz + phase));
  }
  return values;
}

/// Gain and phase of a filtered sine, by projection on sine and cosine over whole periods.
std::pair<double, double> response(double frequency_hz, double rate_hz, double cutoff_hz) {
  const std::size_t n = 2000;
  const auto filtered = low_pass_filter(sine(frequency_hz, rate_hz, n, 0), rate_hz, cutoff_hz);
  double in = 0, quadrature = 0;
  for (std::size_t i = n / 4; i < 3 * n / 4; ++i) {
    const double angle = kTwoPi * frequency_hz * static_cast<double>(i) / rate_hz;
    in += filtered[i] * std::sin(angle);
    quadrature += filtered[i] * std::cos(angle);
  }
  const double half = static_cast<double>(n) / 4;
  return {std::hypot(in, quadrature) / half, std::atan2(quadrature, in)};
}

TEST(LowPass, HasTheGainOfItsFormulaAndNoPhase) {
  const double rate = 100, cutoff = 8;
  for (const double f : {1.0, 3.0, 8.0, 12.0, 20.0}) {
    const double ratio =
        std::tan(std::numbers::pi * f / rate) / std::tan(std::numbers::pi * cutoff / rate);
    const double expected = 1 / (1 + (std::numbers::sqrt2 - 1) * std::pow(ratio, 4));
    const auto [gain, phase] = response(f, rate, cutoff);
    EXPECT_NEAR(gain, expected, 1e-6) << f;
    EXPECT_NEAR(phase, 0, 1e-6) << f;
  }
  EXPECT_NEAR(response(8, rate, cutoff).first, std::sqrt(0.5), 1e-6);
  EXPECT_LT(response(40, rate, cutoff).first, 1e-3);
}

TEST(LowPass, LeavesConstantsAndLinesAlone) {
  std::vector<double> line;
  for (std::size_t i = 0; i < 400; ++i) line.push_back(3 - 0.25 * static_cast<double>(i));
  const auto filtered = low_pass_filter(line, 100, 8);
  ASSERT_EQ(filtered.size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(filtered[i], line[i], 1e-5);
  for (const std::size_t n : {1u, 2u, 5u, 400u}) {
    const auto constant = low_pass_filter(std::vector<double>(n, 7.5), 100, 8);
    ASSERT_EQ(constant.size(), n);
    for (const double value : constant) EXPECT_NEAR(value, 7.5, 1e-12);
  }
}

TEST(LowPass, IsTheSameBackwards) {
  auto values = sine(2.3, 100, 300, 0.4);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.001 * static_cast<double>(i);
  const auto forwards = low_pass_filter(values, 100, 8);
  const std::vector<double> reversed(values.rbegin(), values.rend());
  const auto backwards = low_pass_filter(reversed, 100, 8);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(forwards[i], backwards[values.size() - 1 - i], 1e-5);
  }
}

}  // namespace
}  // namespace morphe::math
