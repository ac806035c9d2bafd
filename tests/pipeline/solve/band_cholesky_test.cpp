#include "pipeline/solve/band_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

namespace morphe::solve {
namespace {

using Eigen::Index;

/// A random positive definite matrix within the band: L Lᵀ of a banded L.
Eigen::MatrixXd banded(Index frames, Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(frames * n, frames * n);
  for (Index i = 0; i < frames * n; ++i) {
    for (Index j = 0; j < i; ++j) {
      if (i / n - j / n <= BandCholesky::kBandBlocks) factor(i, j) = normal(random);
    }
    factor(i, i) = 2 * std::sqrt(4.0 * static_cast<double>(n)) + std::abs(normal(random));
  }
  return factor * factor.transpose();
}

void fill(const Eigen::MatrixXd& dense, Index n, BandCholesky& band) {
  const Index frames = dense.rows() / n;
  band.resize(static_cast<std::size_t>(frames), n);
  for (Index f = 0; f < frames; ++f) {
    band.clear(static_cast<std::size_t>(f));
    for (Index before = 0; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      band.block(static_cast<std::size_t>(f), before) = dense.block(f * n, (f - before) * n, n, n);
    }
  }
}

TEST(BandCholesky, SolvesAsADenseFactorDoes) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  BandCholesky band;
  for (const auto& [frames, n] :
       {std::pair<Index, Index>{1, 3}, {2, 5}, {3, 1}, {4, 4}, {9, 7}, {5, 8}, {6, 13}, {12, 22}}) {
    const Eigen::MatrixXd dense = banded(frames, n, random);
    Eigen::VectorXd b(frames * n);
    for (double& value : b) value = normal(random);
    fill(dense, n, band);
    ASSERT_TRUE(band.factorise());
    Eigen::VectorXd x = b;
    band.solve(x);
    EXPECT_LE((dense * x - b).norm(), 1e-10 * dense.norm() * x.norm()) << frames << " x " << n;
  }
}

TEST(BandCholesky, SaysSoWhereAMatrixIsNotPositiveDefinite) {
  std::mt19937 random(2);
  Eigen::MatrixXd dense = banded(6, 4, random);
  dense(13, 13) -= 2 * dense(13, 13);
  BandCholesky band;
  fill(dense, 4, band);
  EXPECT_FALSE(band.factorise());
}

}  // namespace
}  // namespace morphe::solve
