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
      result.stop_reason = "not tried: no collision to keep clear of";
      return result;
    }
    map::MapOptions options = solving.options;
    if (exactly) options.movement.iterations *= 2;
    if (!exactly) options.movement.relative_value *= kCoarseToleranceFactor;
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
  return one_of("re-solve gently", {re_solve_strategy(solving, "clearance 10 times as heavy", {10}),
                                    re_solve_strategy(solving, "100 times", {100})});
}

RepairStrategy re_solve_strongly(const ReSolveContext& solving) {
  return one_of("re-solve firmly",
                {re_solve_strategy(solving, "clearance 1000 times as heavy", {1000}),
                 re_solve_strategy(solving, "10000 times, just free", {10000, 0.2}),
                 re_solve_strategy(solving, "tips and freedom alone", kStrongestWeights, true)});
}

}  // namespace morphe::planning
