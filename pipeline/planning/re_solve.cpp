#include "pipeline/planning/re_solve.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/planning/clearance_weights.hpp"
#include "stages/map/re_solve_path.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;
using repair::RepairStrategy;
using repair::StrategyResult;

/// relaxes the tolerance, because only freedom from collision matters at first
constexpr double kCoarseToleranceFactor = 100;

/// Returns the strategy for one set of weights. With `exactly`, it uses twice the iterations and
/// the requested tolerances.
RepairStrategy re_solve_strategy(const ReSolveContext& solving, std::string name,
                                 const ClearanceWeights& firmness, bool exactly = false) {
  const auto make = [solving, firmness, exactly](const CheckedPath& best) {
    repair::StrategyResult result{best};
    const bool tips_alone = std::ranges::none_of(best.findings, is_collision, &Finding::cause);
    if (tips_alone && firmness.band_scale == 1) {
      result.stop_reason = "skipped (no collision left)";
      return result;
    }
    map::MapOptions options = solving.options;
    if (exactly) options.movement_solver.max_iterations *= 2;
    if (!exactly) options.movement_solver.relative_tolerance *= kCoarseToleranceFactor;
    result.candidate.path = map::re_solve_path(with_clearance_weights(solving.whole, firmness),
                                               best.path, best.findings, options);
    result.candidate.findings = solving.check(result.candidate.path);
    return result;
  };
  return {std::move(name), make};
}

/// Combines several strategies into one.
RepairStrategy one_of(std::string name, std::vector<RepairStrategy> rungs) {
  return {std::move(name), [rungs = std::move(rungs)](const CheckedPath& best) {
            return repair::run_strategies(rungs, best);
          }};
}

}  // namespace

RepairStrategy re_solve_mildly(const ReSolveContext& solving) {
  return one_of("re-solve, low clearance weights",
                {re_solve_strategy(solving, "clearance weight x 10", {10}),
                 re_solve_strategy(solving, "clearance weight x 100", {100})});
}

RepairStrategy re_solve_strongly(const ReSolveContext& solving) {
  return one_of("re-solve, high clearance weights",
                {re_solve_strategy(solving, "clearance weight x 1000", {1000}),
                 re_solve_strategy(solving, "clearance weight x 10000, activation distance x 0.2",
                                   {10000, 0.2}),
                 re_solve_strategy(solving, "tips and clearance only", kStrongestWeights, true)});
}

}  // namespace morphe::planning
