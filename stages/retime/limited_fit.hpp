#pragma once

#include "core/math/banded.hpp"

namespace morphe::retime {

/// Adds the term weight * (form · c)^2 to the normal equations; `form` has six values, for the
/// coefficients from `first` on.
void add_form(math::BandedMatrix& normal, Eigen::Index first, double weight, const double* form);

/// Returns a factor of the matrix, with additional damping if rounding made it indefinite.
math::BandedMatrix factor_damped(const math::BandedMatrix& normal);

/// The multipliers of the [5 intervals + 1] Bézier points of one joint's quintic B-spline. The
/// method of multipliers pulls points that left the limits towards a target that is inside the
/// limit by `shift`, the sum of their excesses in previous rounds. Both vectors are empty before
/// the first pull.
struct LimitMultipliers {
  Eigen::VectorXd side;   ///< 1: pulled down onto the upper limit, -1: up onto the lower, 0: free
  Eigen::VectorXd shift;  ///< >= 0 [rad]
};

/// The least-squares problem of one joint: normal * c = right, with lower <= curve <= upper.
struct LimitedFit {
  const math::BandedMatrix& normal;
  const Eigen::VectorXd& right;
  const Eigen::VectorXd& weight;  ///< [intervals] weight of the pulled points
  double lower = 0, upper = 0;
};

/// Replaces `solution`, the coefficients of the unconstrained fit, by some whose curve stays inside
/// the limits to half of kLimitInset_rad. `pull` keeps the multipliers for the next fit. An
/// interval's curve is inside the hull of its Bézier points. That of its coefficients is wider: it
/// exceeds a limit at which a path begins and which it leaves at once. If points are still outside
/// after kMaxPulls rounds, the coefficients of their intervals are clamped.
void solve_within_limits(const LimitedFit& fit, LimitMultipliers& pull, Eigen::VectorXd& solution);

}  // namespace morphe::retime
