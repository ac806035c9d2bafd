#pragma once

#include "core/math/banded.hpp"

namespace morphe::retime {

/// margin to the joint limits that absorbs rounding [rad]
inline constexpr double kLimitInset_rad = 1e-7;

/// Adds weight * (form . c)^2 over the six coefficients from `first` on to the normal equations.
void add_form(math::BandedMatrix& normal, Eigen::Index first, double weight, const double* form);

/// Returns a factor of the matrix, with additional damping if rounding made it indefinite.
math::BandedMatrix factor_damped(const math::BandedMatrix& normal);

/// The multipliers of the Bézier points of one joint's quintic B-spline that left its limits. The
/// method of multipliers pulls them back onto the limits, beyond the limit by `shift`, the amount
/// by which they were outside in previous rounds.
struct LimitMultipliers {
  /// [5 intervals + 1] 1: pulled down onto the upper limit, -1: pulled up onto the lower, 0: free
  Eigen::VectorXd side;
  Eigen::VectorXd shift;  ///< [5 intervals + 1] >= 0; both are empty before the first pull
};

/// The least-squares problem of one joint: normal * c = right, with lower <= curve <= upper.
struct LimitedFit {
  const math::BandedMatrix& normal;
  const Eigen::VectorXd& right;
  const Eigen::VectorXd& weight;  ///< [intervals] weight of the pulled points
  double lower = 0, upper = 0;
};

/// Solves for coefficients whose curve stays inside the limits to half of kLimitInset_rad, starting
/// from those of the unconstrained fit. The curve of an interval is inside the convex hull of its
/// Bézier points, a tighter bound than its coefficients: a path that moves away from a limit at
/// once has coefficients beyond it, but no such Bézier points. Points that are still outside after
/// twenty rounds are clamped.
void solve_within_limits(const LimitedFit& fit, LimitMultipliers& pull,
                         Eigen::VectorXd& coefficient);

}  // namespace morphe::retime
