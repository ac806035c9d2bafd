#include "pipeline/study/correlation.hpp"

#include <cmath>

#include "core/motion/geometry.hpp"

namespace morphe::study {

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const Eigen::Index n = std::ssize(a);
  if (n < 2) return kUnknown;
  const Eigen::Map<const Eigen::ArrayXd> x(a.data(), n), y(b.data(), n);
  const Eigen::ArrayXd dx = x - x.mean(), dy = y - y.mean();
  return (dx * dy).sum() / std::sqrt(dx.square().sum() * dy.square().sum());
}

}  // namespace morphe::study
