#include "core/solve/envelope_cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::solve {
namespace {

using Eigen::Index;
using Lanes = Eigen::Array4d;
constexpr Index kLanes = Lanes::SizeAtCompileTime;

Index padded(Index count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// Subtracts a multiple of `other` from the first `count` entries of `row`, including its padding.
void subtract(double* row, double multiple, const double* other, Index count) {
  for (Index k = 0; k < count; k += kLanes)
    Eigen::Map<Lanes>(row + k) -= multiple * Eigen::Map<const Lanes>(other + k);
}

}  // namespace

/// Returns the entries of s_p from `from` to p - 1.
Eigen::Map<const JointVector> EnvelopeCholesky::before(Index pivot, Index from) const {
  return {rows.data() + pivot * rows.cols() + from, pivot - from};
}

bool EnvelopeCholesky::factorise(const Eigen::MatrixXd& hessian, double damping,
                                 const std::vector<char>& held) {
  const Index n = hessian.rows();
  if (rows.rows() != n) {
    rows.setZero(n, padded(n));
    inverse_pivot.resize(n);
  }
  for (Index p = 0; p < n; ++p) {
    double* row = rows.data() + p * rows.cols();
    std::fill(row + p + 1, row + padded(p + 1), 0);
    if (held[p]) {
      std::fill_n(row, p + 1, 0);
    } else {
      std::copy_n(hessian.data() + p * n, p + 1, row);
      row[p] += damping;
    }
  }
  for (Index j = 0; j < n; ++j)
    if (held[j]) rows.col(j).tail(n - j).setZero();
  for (Index p = n; p-- > 0;) {
    double* row = rows.data() + p * rows.cols();
    if (held[p]) {
      inverse_pivot[p] = 1;
      continue;
    }
    if (!(row[p] > 1e-14 * std::abs(hessian(p, p) + damping))) {
      const double squared = find_direction_of(p);
      missing_damping = std::max(-row[p], 1e-12 * std::abs(hessian(p, p) + damping)) / squared;
      curvature = row[p] / squared;
      return false;
    }
    inverse_pivot[p] = 1 / std::sqrt(row[p]);
    for (Index k = 0; k < p; ++k) row[k] *= inverse_pivot[p];
    for (Index k = 0; k < p; ++k)
      if (row[k] != 0) subtract(rows.data() + k * rows.cols(), row[k], row, k + 1);
  }
  return true;
}

/// Sets negative_curvature_direction to the v with v_p = 1 and zeros before p for which vᵀ (H +
/// damping I) v is the pivot of p; returns ‖v‖².
double EnvelopeCholesky::find_direction_of(Index pivot) {
  const Index n = rows.rows();
  negative_curvature_direction.setZero(n);
  negative_curvature_direction[pivot] = 1;
  for (Index k = pivot + 1; k < n; ++k) {
    negative_curvature_direction[k] =
        -before(k, pivot).dot(negative_curvature_direction.segment(pivot, k - pivot)) *
        inverse_pivot[k];
  }
  return negative_curvature_direction.squaredNorm();
}

void EnvelopeCholesky::solve(JointVector& right_side) const {
  const Index n = right_side.size();
  for (Index p = n; p-- > 0;) {
    right_side[p] *= inverse_pivot[p];
    right_side.head(p) -= right_side[p] * before(p);
  }
  for (Index p = 0; p < n; ++p)
    right_side[p] = (right_side[p] - before(p).dot(right_side.head(p))) * inverse_pivot[p];
}

}  // namespace morphe::solve
