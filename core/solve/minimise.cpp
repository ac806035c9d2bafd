#include "core/solve/minimise.hpp"

#include <nlopt.hpp>

#include "core/solve/trust_region.hpp"

namespace morphe::solve {
namespace {

struct NloptCall {
  const BoundedProblem* problem;
  Minimum* minimum;
  JointVector x, gradient;
};

double evaluate(unsigned n, const double* x, double* gradient, void* data) {
  NloptCall& call = *static_cast<NloptCall*>(data);
  call.x = Eigen::Map<const JointVector>(x, n);
  const double value = call.problem->objective(call.x, gradient ? &call.gradient : nullptr);
  if (gradient) Eigen::Map<JointVector>(gradient, n) = call.gradient;
  ++call.minimum->evaluations;
  if (value < call.minimum->value) {
    call.minimum->value = value;
    call.minimum->x = call.x;
  }
  return value;
}

}  // namespace

Minimum minimise(const BoundedProblem& problem, const JointVector& start,
                 const MinimiseOptions& options) {
  if (options.algorithm == "trust_region") {
    TrustRegionScratch scratch;
    return minimise_trust_region(problem, start, options, scratch);
  }
  Minimum minimum;
  minimum.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  minimum.value = kInfinity;
  NloptCall call{&problem, &minimum, minimum.x, JointVector::Zero(start.size())};

  const nlopt::algorithm algorithm = options.algorithm == "slsqp" ? nlopt::LD_SLSQP
                                     : options.algorithm == "lbfgs"
                                         ? nlopt::LD_LBFGS
                                         : nlopt::LD_TNEWTON_PRECOND_RESTART;
  nlopt::opt solver(algorithm, static_cast<unsigned>(start.size()));
  const auto list = [](const JointVector& v) { return std::vector<double>(v.begin(), v.end()); };
  solver.set_lower_bounds(list(problem.lower));
  solver.set_upper_bounds(list(problem.upper));
  solver.set_min_objective(&evaluate, &call);
  solver.set_maxeval(options.max_evaluations);
  solver.set_ftol_rel(options.relative_tolerance);
  solver.set_xtol_abs(options.step_tolerance_rad);

  std::vector<double> x = list(minimum.x);
  double value = 0;
  try {
    const nlopt::result result = solver.optimize(x, value);
    minimum.converged = result > 0 && result != nlopt::MAXEVAL_REACHED;
  } catch (const std::runtime_error&) {
    // NLopt throws if round-off or the line search stopped it; the point so far is still valid.
    minimum.converged = false;
  }
  return minimum;
}

}  // namespace morphe::solve
