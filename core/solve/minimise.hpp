#pragma once

#include <functional>
#include <string>

#include "core/solve/quadratic.hpp"

namespace morphe::solve {

/// minimise F(x) subject to lower <= x <= upper.
struct BoundedProblem {
  JointVector lower, upper;
  /// Value at x; fills the gradient [n] if it is not null. For NLopt.
  std::function<double(const JointVector& x, JointVector* gradient)> objective;
  /// Adds value, gradient and Hessian at x to a model that was reset to [n]; the Hessian may be
  /// indefinite. For the structured solver.
  std::function<void(const JointVector& x, Quadratic& model)> model;
};

struct MinimiseOptions {
  /// "structured": projected Newton of our own. NLopt's: "tnewton" (LD_TNEWTON_PRECOND_RESTART),
  /// "slsqp" or "lbfgs".
  std::string algorithm = "structured";
  int evaluations = 400;            ///< limit; never a time limit
  double relative_value = 1e-10;    ///< stop when a step changes F by less than this share
  double absolute_step_rad = 1e-7;  ///< or x by less than this
};
template <class Fields>
void fields(Fields& f, MinimiseOptions& o) {
  f("algorithm", o.algorithm);
  f("evaluations", o.evaluations);
  f("relative_value", o.relative_value);
  f("absolute_step_rad", o.absolute_step_rad);
}
std::string why_invalid(const MinimiseOptions& options);

struct Minimum {
  JointVector x;  ///< best point seen, inside the bounds
  double value = 0;
  int evaluations = 0;
  bool converged = false;  ///< false: stopped by the limit or by NLopt's round-off guard
};

/// Local minimum from a start (clamped into the bounds). Deterministic.
Minimum minimise(const BoundedProblem& problem, const JointVector& start,
                 const MinimiseOptions& options);

}  // namespace morphe::solve
