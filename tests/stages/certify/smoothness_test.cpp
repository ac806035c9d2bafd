#include "stages/certify/smoothness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::certify {
namespace {

SpeedProfile sampled(double duration_s, double step_s, const std::function<double(double)>& speed) {
  SpeedProfile profile{{}, step_s};
  for (double t = 0; t <= duration_s + 1e-9; t += step_s) profile.speed.push_back(speed(t));
  return profile;
}

double minimum_jerk(double z) { return 30 * z * z * (1 - z) * (1 - z); }

TEST(Smoothness, DimensionlessJerkOfAMinimumJerkReach) {
  // v = 30 z² (1 - z)² A / T: peak 1.875 A / T, integral of the squared jerk 720 A² / T⁵.
  const double expected = -std::log(720 / (1.875 * 1.875));
  for (const double duration_s : {0.5, 2.0}) {
    const SpeedProfile profile = sampled(duration_s, duration_s / 1000, [&](double t) {
      return 0.3 * minimum_jerk(t / duration_s);
    });
    EXPECT_NEAR(log_dimensionless_jerk(profile), expected, 0.02);
  }
}

TEST(Smoothness, ArcLengthOfAGaussianSpectrum) {
  // v = e^(-t²/2s²) has |V(f)| / |V(0)| = e^(-(2 pi f s)²/2): its curve down to 0.05, integrated.
  const double s = 0.12;
  const SpeedProfile profile =
      sampled(2, 0.005, [&](double t) { return std::exp(-0.5 * std::pow((t - 1) / s, 2)); });
  const double end_hz = std::sqrt(-2 * std::log(0.05)) / (2 * std::numbers::pi * s);
  double length = 0;
  constexpr int kSteps = 100000;
  for (int k = 0; k < kSteps; ++k) {
    const double f = (k + 0.5) * end_hz / kSteps, w = 2 * std::numbers::pi * s;
    const double slope = w * w * f * std::exp(-0.5 * w * w * f * f);
    length += std::hypot(1 / end_hz, slope) * end_hz / kSteps;
  }
  EXPECT_NEAR(spectral_arc_length(profile), -length, 0.01);
}

TEST(Smoothness, DoesNotDependOnSizeAndFallsWithSubmovements) {
  const auto reach = [](double t) { return minimum_jerk(t); };
  const auto twice = [](double t) {
    return minimum_jerk(std::fmod(2 * t, 1.0)) * (t < 0.5 ? 1 : 0.4);
  };
  const SpeedProfile one = sampled(1, 0.01, reach), two = sampled(1, 0.01, twice);
  SpeedProfile large = one;
  for (double& v : large.speed) v *= 7;
  EXPECT_NEAR(spectral_arc_length(large), spectral_arc_length(one), 1e-12);
  EXPECT_NEAR(log_dimensionless_jerk(large), log_dimensionless_jerk(one), 1e-12);
  EXPECT_LT(spectral_arc_length(two), spectral_arc_length(one) - 0.1);
  EXPECT_LT(log_dimensionless_jerk(two), log_dimensionless_jerk(one) - 1);
}

TEST(Smoothness, NothingWithoutMotion) {
  for (const SpeedProfile& profile :
       {SpeedProfile{}, SpeedProfile{{1, 1}, 0.01}, SpeedProfile{{0, 0, 0, 0}, 0.01}}) {
    EXPECT_TRUE(std::isnan(spectral_arc_length(profile)));
    EXPECT_TRUE(std::isnan(log_dimensionless_jerk(profile)));
  }
}

Goals circling(std::size_t frames) {
  Goals goals;
  goals.tip_position = Array2D<Vec3>(frames, 2, unknown_point());
  for (std::size_t f = 0; f < frames; ++f) {
    const double t = 0.01 * static_cast<double>(f);
    goals.time.push_back(5 + t);
    goals.tip_position(f, 0) = Vec3(std::cos(3 * t), std::sin(3 * t), 0);
  }
  return goals;
}

TEST(Smoothness, SpeedsOfTheTipsThatHaveGoals) {
  const Goals goals = circling(41);
  const SpeedProfile human = human_speed(goals);
  ASSERT_EQ(human.speed.size(), 39u);
  EXPECT_NEAR(human.step_s, 0.01, 1e-12);
  for (const double v : human.speed) EXPECT_NEAR(v, 2 * std::sin(0.03) / 0.02, 1e-12);

  const SpeedProfile robot = robot_speed(planar_arm(), goals, sweep(0.5));
  ASSERT_EQ(robot.speed.size(), 99u);
  const auto angle = [](double t) { return 0.5 * t * t * t * (10 - 15 * t + 6 * t * t); };
  for (std::size_t k = 0; k < robot.speed.size(); ++k) {
    const double t = 0.01 * static_cast<double>(k + 1);
    const double chord =
        2 * std::hypot(0.55, 0.04) * std::sin(0.5 * (angle(t + 0.01) - angle(t - 0.01)));
    EXPECT_NEAR(robot.speed[k], chord / 0.02, 1e-10);
  }
}

TEST(Smoothness, ATipThatIsLostOnceDoesNotCount) {
  Goals goals = circling(41);
  goals.tip_position(7, 0) = unknown_point();
  EXPECT_TRUE(human_speed(goals).speed.empty());
  EXPECT_TRUE(robot_speed(planar_arm(), goals, sweep(0.5)).speed.empty());
}

}  // namespace
}  // namespace morphe::certify
