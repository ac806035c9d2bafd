#include "core/math/banded.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::math {
namespace {

using Eigen::Index;

template <class RightSide>
void substitute(const BandedMatrix& m, RightSide& b) {
  for (Index i = 0; i < m.size; ++i) {
    for (Index d = 1; d <= std::min(m.bandwidth, i); ++d) b.row(i) -= m.entry(i, d) * b.row(i - d);
    b.row(i) /= m.entry(i, 0);
  }
  for (Index i = m.size - 1; i >= 0; --i) {
    b.row(i) /= m.entry(i, 0);
    for (Index d = 1; d <= std::min(m.bandwidth, i); ++d) b.row(i - d) -= m.entry(i, d) * b.row(i);
  }
}

}  // namespace

bool factor(BandedMatrix& m) {
  for (Index i = 0; i < m.size; ++i) {
    const Index first = std::max<Index>(0, i - m.bandwidth);
    for (Index j = first; j <= i; ++j) {
      double sum = m.entry(i, i - j);
      for (Index k = std::max(first, j - m.bandwidth); k < j; ++k)
        sum -= m.entry(i, i - k) * m.entry(j, j - k);
      if (j < i) {
        m.entry(i, i - j) = sum / m.entry(j, 0);
      } else {
        if (!(sum > 0)) return false;
        m.entry(i, 0) = std::sqrt(sum);
      }
    }
  }
  return true;
}

void solve_factored(const BandedMatrix& m, Eigen::Ref<Eigen::VectorXd> b) { substitute(m, b); }
void solve_factored(const BandedMatrix& m, JointRows& b) { substitute(m, b); }

}  // namespace morphe::math
