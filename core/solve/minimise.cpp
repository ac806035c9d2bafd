#include "core/solve/minimise.hpp"

#include <array>
#include <nlopt.hpp>
#include <utility>

#include "core/solve/trust_region.hpp"

namespace morphe::solve {
namespace {

constexpr std::array<std::pair<const char*, nlopt::algorithm>, 3> kAlgorithms{{
    {"tnewton", nlopt::LD_TNEWTON_PRECOND_RESTART},
    {"slsqp", nlopt::LD_SLSQP},
    {"lbfgs", nlopt::LD_LBFGS},
}};

struct NloptCall {
  const BoundedProblem* problem;
  Minimum* best;
  JointVector x, gradient;
};

double evaluate(unsigned n, const double* x, double* gradient, void* data) {
  NloptCall& call = *static_cast<NloptCall*>(data);
  const auto size = static_cast<Eigen::Index>(n);
  call.x = Eigen::Map<const JointVector>(x, size);
  const double value = call.problem->objective(call.x, gradient ? &call.gradient : nullptr);
  if (gradient) Eigen::Map<JointVector>(gradient, size) = call.gradient;
  ++call.best->evaluations;
  if (value < call.best->value) {
    call.best->value = value;
    call.best->x = call.x;
  }
  return value;
}

}  // namespace

std::string validation_error(const MinimiseOptions& options) {
  if (options.algorithm == "structured")
    return "algorithm: 'structured' is now called 'trust_region'";
  bool known = options.algorithm == "trust_region";
  for (const auto& entry : kAlgorithms) known |= options.algorithm == entry.first;
  if (!known)
    return "algorithm must be trust_region, tnewton, slsqp or lbfgs, not '" + options.algorithm +
           "'";
  if (options.max_evaluations < 1) return "max_evaluations must be at least 1";
  return "";
}

Minimum minimise(const BoundedProblem& problem, const JointVector& start,
                 const MinimiseOptions& options) {
  if (options.algorithm == "trust_region") {
    TrustRegionScratch scratch;
    return minimise_trust_region(problem, start, options, scratch);
  }
  Minimum best;
  best.x = start.cwiseMax(problem.lower).cwiseMin(problem.upper);
  best.value = std::numeric_limits<double>::infinity();
  NloptCall call{&problem, &best, best.x, JointVector::Zero(start.size())};

  nlopt::algorithm algorithm = kAlgorithms.front().second;
  for (const auto& entry : kAlgorithms) {
    if (options.algorithm == entry.first) algorithm = entry.second;
  }
  nlopt::opt solver(algorithm, static_cast<unsigned>(start.size()));
  const auto list = [](const JointVector& v) {
    return std::vector<double>(v.data(), v.data() + v.size());
  };
  solver.set_lower_bounds(list(problem.lower));
  solver.set_upper_bounds(list(problem.upper));
  solver.set_min_objective(&evaluate, &call);
  solver.set_maxeval(options.max_evaluations);
  solver.set_ftol_rel(options.relative_tolerance);
  solver.set_xtol_abs(options.step_tolerance_rad);

  std::vector<double> x = list(best.x);
  double value = 0;
  try {
    const nlopt::result result = solver.optimize(x, value);
    best.converged = result > 0 && result != nlopt::MAXEVAL_REACHED;
  } catch (const std::runtime_error&) {
    // NLopt throws if round-off or the line search stopped it; the best point is still valid.
    best.converged = false;
  }
  return best;
}

}  // namespace morphe::solve
