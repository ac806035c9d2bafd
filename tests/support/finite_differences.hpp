#pragma once

#include <functional>

#include "core/motion/geometry.hpp"

namespace morphe {

/// Central differences of a scalar function.
inline JointVector numeric_gradient(const std::function<double(const JointVector&)>& function,
                                    const JointVector& q, double step = 1e-6) {
  JointVector gradient(q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    JointVector up = q, down = q;
    up[j] += step;
    down[j] -= step;
    gradient[j] = (function(up) - function(down)) / (2 * step);
  }
  return gradient;
}

}  // namespace morphe
