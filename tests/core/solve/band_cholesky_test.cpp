#include "core/solve/band_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

namespace morphe::solve {
namespace {

using Eigen::Index;

/// A random positive definite matrix of full blocks that diagonal ones join, within the band.
Eigen::MatrixXd banded(Index frames, Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(frames * n, frames * n);
  for (Index f = 0; f < frames; ++f) {
    Eigen::MatrixXd own(n, n);
    for (double& value : own.reshaped()) value = normal(random);
    matrix.block(f * n, f * n, n, n) = own * own.transpose();
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      for (Index j = 0; j < n; ++j) {
        const Index row = f * n + j, column = row - before * n;
        const double joins = normal(random);
        matrix(row, column) = matrix(column, row) = joins;
        matrix(row, row) += std::abs(joins);
        matrix(column, column) += std::abs(joins);
      }
    }
  }
  matrix.diagonal().array() += 0.01;
  return matrix;
}

void fill(const Eigen::MatrixXd& dense, Index n, BandCholesky& band) {
  const Index frames = dense.rows() / n;
  band.resize(static_cast<std::size_t>(frames), n);
  for (Index f = 0; f < frames; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    band.clear_row(frame);
    band.diagonal_block(frame) = dense.block(f * n, f * n, n, n);
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      band.off_diagonal(frame, before) = dense.block(f * n, (f - before) * n, n, n).diagonal();
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
