#pragma once

#include <Eigen/Core>

namespace morphe::retime {

/// A path q(u) on a grid of equal steps, with the bounds of the path velocity du/dt.
struct PathGrid {
  double step = 1;                ///< of u, > 0
  Eigen::ArrayXXd first, second;  ///< [n, N + 1] dq/du, d2q/du2, each / the acceleration limit
  Eigen::ArrayXd ceiling;         ///< [N + 1] upper bound of x = (du/dt)^2, > 0, may be infinite
};

/// Returns x = (du/dt)^2 of the fastest motion from rest to rest at the grid points; x is linear
/// between them. The constraints are
///   |q'' x + q' x_u / 2| <= a  and  x <= ceiling
/// at both ends of every step. Reachability analysis (Pham and Pham, TOPP-RA): The backward pass
/// finds, for each grid point, the largest x from which the motion can still be brought to rest; as
/// x = 0 is always feasible, the controllable set is [0, largest x]. The forward pass takes the
/// largest x that stays in these sets. No x exceeds kMaxPathVelocity^2.
Eigen::VectorXd fastest_squared_velocities(const PathGrid& grid);

/// A path velocity profile on a grid, as a function of time.
struct GridLaw {
  double step = 1;
  Eigen::VectorXd square;  ///< x at the grid points
  Eigen::VectorXd time;    ///< at the grid points, from 0 [s]
};
/// Integrates the time along a profile of squared path velocities.
GridLaw grid_law(double step, Eigen::VectorXd square);
/// Returns u at a time, clamped to the ends.
double clock_at(const GridLaw& law, double time_s);

}  // namespace morphe::retime
