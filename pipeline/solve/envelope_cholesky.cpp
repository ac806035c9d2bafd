#include "pipeline/solve/envelope_cholesky.hpp"

#include <cmath>

namespace morphe::solve {

using Eigen::Index;

bool EnvelopeCholesky::factorise(const Eigen::MatrixXd& hessian, double damping,
                                 const std::vector<char>& held) {
  const Index n = hessian.rows();
  if (rows.rows() != n) {
    rows.resize(n, n);
    first.resize(static_cast<std::size_t>(n));
    inverse_pivot.resize(n);
  }
  for (Index i = 0; i < n; ++i) {
    const Index variable = n - 1 - i;
    double* row = rows.data() + i * n;
    Index begin = i;
    if (!held[static_cast<std::size_t>(variable)]) {
      // Column `variable` of the lower triangle, from the bottom upwards.
      const double* column = hessian.data() + variable * n;
      for (Index j = 0; j < i; ++j) {
        const Index other = n - 1 - j;
        const double entry = held[static_cast<std::size_t>(other)] ? 0 : column[other];
        row[j] = entry;
        if (entry != 0 && begin == i) begin = j;
      }
    }
    first[static_cast<std::size_t>(i)] = begin;
    for (Index j = begin; j < i; ++j) {
      const Index from = std::max(begin, first[static_cast<std::size_t>(j)]);
      const double* other = rows.data() + j * n;
      double sum = row[j];
      if (j > from) {
        sum -= Eigen::Map<const JointVector>(row + from, j - from)
                   .dot(Eigen::Map<const JointVector>(other + from, j - from));
      }
      row[j] = sum * inverse_pivot[j];
    }
    if (held[static_cast<std::size_t>(variable)]) {
      inverse_pivot[i] = 1;
      continue;
    }
    const double own = hessian(variable, variable) + damping;
    const double pivot = own - Eigen::Map<const JointVector>(row + begin, i - begin).squaredNorm();
    if (!(pivot > 1e-14 * std::abs(own))) {
      const double squared = squared_length_at(i);
      missing = std::max(-pivot, 1e-12 * std::abs(own)) / squared;
      curvature = pivot / squared;
      return false;
    }
    inverse_pivot[i] = 1 / std::sqrt(pivot);
  }
  return true;
}

/// ‖v‖² of the v with v_i = 1 and nothing after row i for which vᵀ H v is row i's pivot.
double EnvelopeCholesky::squared_length_at(Index i) {
  direction.setZero(rows.rows());
  direction[i] = 1;
  for (Index k = first[static_cast<std::size_t>(i)]; k < i; ++k) direction[k] = -rows(i, k);
  for (Index k = i; k-- > 0;) {
    const Index begin = first[static_cast<std::size_t>(k)], length = k - begin;
    direction[k] *= inverse_pivot[k];
    direction.segment(begin, length) -=
        direction[k] * Eigen::Map<const JointVector>(rows.data() + k * rows.cols() + begin, length);
  }
  return direction.dot(direction);
}

void EnvelopeCholesky::solve(JointVector& right_side) const {
  const Index n = right_side.size();
  // In the order of elimination the vector is read backwards.
  right_side.reverseInPlace();
  for (Index i = 0; i < n; ++i) {
    const Index begin = first[static_cast<std::size_t>(i)], length = i - begin;
    const Eigen::Map<const JointVector> row(rows.data() + i * n + begin, length);
    right_side[i] = (right_side[i] - row.dot(right_side.segment(begin, length))) * inverse_pivot[i];
  }
  for (Index i = n; i-- > 0;) {
    const Index begin = first[static_cast<std::size_t>(i)], length = i - begin;
    const Eigen::Map<const JointVector> row(rows.data() + i * n + begin, length);
    right_side[i] *= inverse_pivot[i];
    right_side.segment(begin, length) -= right_side[i] * row;
  }
  right_side.reverseInPlace();
}

}  // namespace morphe::solve
