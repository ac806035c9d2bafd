#include "core/solve/bounded_problem.hpp"

#include <algorithm>
#include <array>

namespace morphe::solve {

std::string validation_error(const MinimiseOptions& options) {
  constexpr std::array kAlgorithms = {"trust_region", "tnewton", "slsqp", "lbfgs"};
  const std::string& algorithm = options.algorithm;
  if (algorithm == "structured") return "algorithm: 'structured' is now called 'trust_region'";
  if (std::ranges::find(kAlgorithms, algorithm) == kAlgorithms.end())
    return "algorithm must be trust_region, tnewton, slsqp or lbfgs, not '" + algorithm + "'";
  return "";
}

}  // namespace morphe::solve
