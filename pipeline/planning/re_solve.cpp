#include "pipeline/planning/re_solve.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/planning/constants.hpp"
#include "stages/map/re_solve_path.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;
using repair::RepairStrategy;
using repair::StrategyResult;

/// Returns the strategy for one set of weights. With `exactly`, it uses twice the iterations and
/// the configured tolerance, otherwise kCoarseToleranceFactor times the tolerance. A path without
/// collisions is skipped at the full clearance distance, because more clearance cannot help it.
RepairStrategy re_solve_strategy(const ReSolveContext& context, std::string name,
                                 const ClearanceWeights& weights, bool exactly = false) {
  const auto make = [context, weights, exactly](const CheckedPath& best) {
    repair::StrategyResult result{best};
    const bool no_collisions = std::ranges::none_of(best.findings, is_collision, &Finding::cause);
    if (no_collisions && weights.band_scale == 1) {
      result.stop_reason = "skipped (no collision left)";
      return result;
    }
    map::MapOptions options = context.options;
    if (exactly) options.movement_solver.max_iterations *= 2;
    if (!exactly) options.movement_solver.relative_tolerance *= kCoarseToleranceFactor;
    result.candidate.path = map::re_solve_path(with_clearance_weights(context.whole, weights),
                                               best.path, best.findings, options);
    result.candidate.findings = context.check(result.candidate.path);
    return result;
  };
  return {std::move(name), make};
}

/// Returns the strategy that applies several strategies in order.
RepairStrategy chain(std::string name, std::vector<RepairStrategy> strategies) {
  return {std::move(name), [strategies = std::move(strategies)](const CheckedPath& best) {
            return repair::run_strategies(strategies, best);
          }};
}

}  // namespace

RepairStrategy re_solve_closely(const ReSolveContext& context) {
  return chain(
      "re-solve, close to the goals",
      {re_solve_strategy(context, "clearance weight x 10, activation distance x 0.2", {10, 0.2}),
       re_solve_strategy(context, "clearance weight x 100, activation distance x 0.2", {100, 0.2}),
       re_solve_strategy(context, "clearance weight x 1000, activation distance x 0.2",
                         {1000, 0.2})});
}

RepairStrategy re_solve_mildly(const ReSolveContext& context) {
  return chain("re-solve, low clearance weights",
               {re_solve_strategy(context, "clearance weight x 10", {10}),
                re_solve_strategy(context, "clearance weight x 100", {100})});
}

RepairStrategy re_solve_strongly(const ReSolveContext& context) {
  return chain("re-solve, high clearance weights",
               {re_solve_strategy(context, "clearance weight x 1000", {1000}),
                re_solve_strategy(context, "clearance weight x 10000, activation distance x 0.2",
                                  {10000, 0.2}),
                re_solve_strategy(context, "tips and clearance only", kStrongestWeights, true)});
}

}  // namespace morphe::planning
