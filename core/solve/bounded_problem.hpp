#pragma once

#include <functional>
#include <string>

#include "core/motion/key_bounds.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::solve {

/// The problem: minimise F(x) subject to lower <= x <= upper.
struct BoundedProblem {
  JointVector lower, upper;
  /// Returns F(x), and fills the gradient [n] if it is not null; used by NLopt.
  std::function<double(const JointVector& x, JointVector* gradient)> objective;
  /// Adds F's value, gradient and Hessian, possibly indefinite, to a model that was reset to [n].
  std::function<void(const JointVector& x, Quadratic& model)> model;
};

/// The options of minimise().
struct MinimiseOptions {
  /// "trust_region": Morphe's projected Newton method. NLopt's algorithms: "tnewton"
  /// (LD_TNEWTON_PRECOND_RESTART), "slsqp" or "lbfgs".
  std::string algorithm = "trust_region";
  int max_evaluations = 400;          ///< there is no time limit
  double relative_tolerance = 1e-10;  ///< stop if a step changes F by less than this times |F|
  double step_tolerance_rad = 1e-7;   ///< or every x_j by less than this
};
/// Declares the config keys of the options.
template <class Fields>
void fields(Fields& f, MinimiseOptions& o) {
  f("algorithm", o.algorithm);
  f("max_evaluations", o.max_evaluations, bounds::kCount);
  f("relative_tolerance", o.relative_tolerance, bounds::kTolerance);
  f("step_tolerance_rad", o.step_tolerance_rad, bounds::kTolerance);
}
/// Returns the reason why the options are invalid, "" if they are valid.
std::string validation_error(const MinimiseOptions& options);

/// The result of a minimisation.
struct Minimum {
  JointVector x;  ///< the point of least F that was found, inside the bounds
  double value = 0;
  int evaluations = 0;
  bool converged = false;  ///< false if stopped by the limit or by NLopt's round-off guard
};

}  // namespace morphe::solve
