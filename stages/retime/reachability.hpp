#pragma once

#include <Eigen/Core>

namespace morphe::retime {

/// A path q(u) on a grid of equal steps, with what bounds the pace du/dt along it.
struct PaceGrid {
  double step = 1;  ///< of u, > 0
  Eigen::ArrayXXd first,
      second;              ///< [n, N + 1] dq/du and d2q/du2, each over the acceleration limit
  Eigen::ArrayXd ceiling;  ///< [N + 1] of x = (du/dt)^2, > 0, may be infinite
};

/// x = (du/dt)^2 at the grid points, linear between them, of the fastest motion from rest to rest:
///   |q'' x + q' x_u / 2| <= a  and  x <= ceiling
/// at both ends of every step. Reachability analysis (Pham and Pham, TOPP-RA): backwards, the
/// largest x from which the rest can be braked (0 can be kept everywhere, so that the controllable
/// sets are [0, largest]); forwards, the largest x that stays in them. No x exceeds kMostPace^2.
inline constexpr double kMostPace = 1e4;
Eigen::VectorXd fastest_squares(const PaceGrid& grid);

/// A pace on a grid as motion over time.
struct GridLaw {
  double step = 1;
  Eigen::VectorXd square;  ///< x at the grid points
  Eigen::VectorXd time;    ///< at the grid points, from 0 [s]
};
GridLaw grid_law(double step, Eigen::VectorXd square);
/// u at a time; the ends beyond them.
double clock_at(const GridLaw& law, double time_s);

}  // namespace morphe::retime
