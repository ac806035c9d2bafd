#include "stages/retime/reachability.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/geometry.hpp"
#include "stages/retime/constants.hpp"

namespace morphe::retime {
namespace {

/// A bound of a = x_u / 2 and its derivative with respect to x.
struct Bound {
  double value = 0, slope = 0;
};
struct Bounds {
  Bound upper{kInfinity, 0}, lower{-kInfinity, 0};
};

/// The constraints |p a + r x| <= 1 of one step, one row for each joint at each of its ends.
class Step {
 public:
  explicit Step(Eigen::Index joints) : inverse_(2 * joints), slope_(2 * joints) {}

  /// Loads a grid step; at its far end x is x + 2 step a.
  void load(const PathGrid& grid, Eigen::Index i) {
    const Eigen::Index n = grid.first.rows();
    step_ = grid.step;
    for (Eigen::Index k = 0; k < n; ++k) {
      set(k, grid.first(k, i), grid.second(k, i));
      const double far_second = grid.second(k, i + 1);
      set(n + k, grid.first(k, i + 1) + 2 * step_ * far_second, far_second);
    }
  }
  /// Returns the bounds of a at x such that the next x is in [0, next].
  Bounds bounds_at(double x, double next) const {
    const double half = 0.5 / step_;
    Bounds out{{half * (next - x), -half}, {-half * x, -half}};
    for (Eigen::Index k = 0; k < inverse_.size(); ++k) {
      const double middle = -slope_[k] * x;
      if (middle + inverse_[k] < out.upper.value) out.upper = {middle + inverse_[k], -slope_[k]};
      if (middle - inverse_[k] > out.lower.value) out.lower = {middle - inverse_[k], -slope_[k]};
    }
    return out;
  }

 private:
  void set(Eigen::Index row, double p, double r) {
    if (std::abs(p) < kMinSlope) p = p < 0 ? -kMinSlope : kMinSlope;
    inverse_[row] = 1 / std::abs(p);
    slope_[row] = r / p;
  }
  double step_ = 1;
  Eigen::ArrayXd inverse_, slope_;
};

/// Returns the largest x in [0, ceiling] with a feasible a. The width upper - lower is concave in x
/// and not negative at 0, so that Newton's method from above never passes the root.
double largest_controllable(const Step& step, double ceiling, double next) {
  double x = ceiling;
  for (int k = 0; k < kRootSteps; ++k) {
    const Bounds a = step.bounds_at(x, next);
    const double width = a.upper.value - a.lower.value, slope = a.upper.slope - a.lower.slope;
    if (width >= 0 || !(slope < 0)) break;
    const double root = std::max(0.0, x - width / slope);
    if (!(root < x)) break;
    x = root;
  }
  return x;
}

}  // namespace

Eigen::VectorXd fastest_squared_velocities(const PathGrid& grid) {
  const Eigen::Index steps = grid.ceiling.size() - 1;
  Step step(grid.first.rows());
  Eigen::VectorXd controllable = Eigen::VectorXd::Zero(steps + 1), x = controllable;
  for (Eigen::Index i = steps; i-- > 0;) {
    step.load(grid, i);
    controllable[i] = largest_controllable(
        step, std::min(grid.ceiling[i], kMaxPathVelocity * kMaxPathVelocity), controllable[i + 1]);
  }
  for (Eigen::Index i = 0; i < steps; ++i) {
    step.load(grid, i);
    const double a = step.bounds_at(x[i], controllable[i + 1]).upper.value;
    x[i + 1] = std::clamp(x[i] + 2 * grid.step * a, 0.0, controllable[i + 1]);
  }
  return x;
}

GridLaw grid_law(double step, Eigen::VectorXd square) {
  GridLaw law{step, std::move(square), {}};
  law.time = Eigen::VectorXd::Zero(law.square.size());
  for (Eigen::Index i = 0; i + 1 < law.square.size(); ++i) {
    const double pace = std::sqrt(law.square[i]) + std::sqrt(law.square[i + 1]);
    law.time[i + 1] = law.time[i] + 2 * step / pace;
  }
  return law;
}

double clock_at(const GridLaw& law, double time_s) {
  const double* const begin = law.time.data();
  const Eigen::Index last = law.time.size() - 1;
  const auto i = std::upper_bound(begin, begin + law.time.size(), time_s) - begin - 1;
  if (i < 0) return 0;
  if (i >= last) return static_cast<double>(last) * law.step;
  const double t = time_s - law.time[i];
  const double a = 0.5 * (law.square[i + 1] - law.square[i]) / law.step;
  return static_cast<double>(i) * law.step + t * (std::sqrt(law.square[i]) + 0.5 * a * t);
}

}  // namespace morphe::retime
