#pragma once

#include "core/math/banded.hpp"

namespace morphe::retime {

inline constexpr double kLimitInset = 1e-7;  ///< [rad]: rounding must not leave the limits

/// Adds weight * (form . c)^2 over the six coefficients from `first` on.
void add_form(math::BandedMatrix& normal, Eigen::Index first, double weight, const double* form);

/// A factor of the matrix, with more damping if rounding ate what makes it definite.
math::BandedMatrix factored(const math::BandedMatrix& normal);

/// Bézier points of one joint's quintic B-spline that left its limits, and are pulled back onto
/// them by the method of multipliers: beyond the limit by `shift`, as much as they still lay
/// outside before.
struct LimitPull {
  Eigen::VectorXd side;   ///< [5 intervals + 1] 1: down onto the upper limit, -1: up, 0: free
  Eigen::VectorXd shift;  ///< likewise, >= 0; both empty: nothing was pulled yet
};

/// One joint's least squares: normal * c = right, with lower <= curve <= upper.
struct LimitedFit {
  const math::BandedMatrix& normal;
  const Eigen::VectorXd& right;
  const Eigen::VectorXd& weight;  ///< [intervals] of what is pulled
  double lower = 0, upper = 0;
};

/// Coefficients whose curve stays inside the limits to half of kLimitInset, from those of the
/// unlimited fit. The curve of an interval lies between its Bézier points, more closely than
/// between its coefficients: a way that leaves a limit at once has coefficients beyond it, but no
/// such points. What twenty pulls do not bring inside is cut off.
void solve_inside(const LimitedFit& fit, LimitPull& pull, Eigen::VectorXd& coefficient);

}  // namespace morphe::retime
