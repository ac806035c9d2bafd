#include "stages/map/coarse_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace morphe;
using namespace morphe::map;

namespace {

std::vector<double> times(std::size_t count, double step_s) {
  std::vector<double> time;
  for (std::size_t f = 0; f < count; ++f) time.push_back(1 + step_s * static_cast<double>(f));
  return time;
}

}  // namespace

TEST(CoarseGrid, HoldsBothEndsAndIsEven) {
  EXPECT_EQ(coarse_frames(times(101, 0.01), 0.05).size(), 21u);
  const std::vector<std::size_t> frames = coarse_frames(times(98, 0.01), 0.05);
  EXPECT_EQ(frames.front(), 0u);
  EXPECT_EQ(frames.back(), 97u);
  for (std::size_t k = 1; k < frames.size(); ++k) {
    EXPECT_NEAR(static_cast<double>(frames[k] - frames[k - 1]), 97.0 / 19, 1);
  }
}

TEST(CoarseGrid, HasAtLeastFiveFramesOrAllThereAre) {
  EXPECT_EQ(coarse_frames(times(7, 0.01), 0.05).size(), 5u);
  EXPECT_EQ(coarse_frames(times(3, 0.01), 0.05), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(CoarseGrid, InterpolationMeetsTheRowsAndIsExactForLines) {
  const std::vector<std::size_t> frames{3, 5, 9, 10};
  JointRows coarse(4, 2);
  for (std::size_t k = 0; k < 4; ++k) {
    coarse.row(static_cast<Eigen::Index>(k)) << 2 * static_cast<double>(frames[k]) - 1, 0.5;
  }
  const JointRows fine = interpolate(coarse, frames);
  ASSERT_EQ(fine.rows(), 8);
  for (Eigen::Index f = 0; f < 8; ++f) {
    EXPECT_NEAR(fine(f, 0), 2 * static_cast<double>(f + 3) - 1, 1e-12);
    EXPECT_NEAR(fine(f, 1), 0.5, 1e-15);
  }
}

TEST(CoarseGrid, InterpolationIsExactForParabolasInside) {
  // Central differences of a parabola on an even grid are its slopes.
  const std::vector<std::size_t> frames{0, 4, 8, 12, 16};
  JointRows coarse(5, 1);
  for (std::size_t k = 0; k < 5; ++k) {
    coarse(static_cast<Eigen::Index>(k), 0) = std::pow(static_cast<double>(frames[k]) - 7, 2);
  }
  const JointRows fine = interpolate(coarse, frames);
  for (Eigen::Index f = 4; f <= 12; ++f) {
    EXPECT_NEAR(fine(f, 0), std::pow(static_cast<double>(f) - 7, 2), 1e-12);
  }
}
