#include "pipeline/planning/re_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/planning/constants.hpp"
#include "stages/map/placement.hpp"
#include "stages/map/re_solve_path.hpp"
#include "stages/repair/bridge_collisions.hpp"

namespace morphe::planning {
namespace {

using repair::CheckedPath;
using repair::RepairStrategy;
using repair::StrategyResult;

/// Returns the world in which a path is solved again: a target that is attached to a frame has the
/// pose in it that it has on the path, and keeps clear of other objects, too.
collision::CollisionWorld world_along(const collision::CollisionWorld& world,
                                      const JointPath& path) {
  collision::CollisionWorld along = world;
  if (world.target >= 0 && !world.scene->objects[world.target].attached_frame.empty())
    collision::attach_target(path.demonstration_time, path.position, along);
  return along;
}

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
    const collision::CollisionWorld world = world_along(*context.whole.world, best.path);
    map::MappingProblem problem = with_clearance_weights(context.whole, weights);
    problem.world = &world;
    result.candidate.path = map::re_solve_path(problem, best.path, best.findings, options);
    result.candidate.findings = context.check(result.candidate.path);
    return result;
  };
  return {std::move(name), make};
}

/// Returns the strategy that solves the path again from bridges over its collisions. If the result
/// still collides, but the bridges themselves do not, it is these.
RepairStrategy re_solve_bridge(const ReSolveContext& context, const BridgeAttempt& attempt) {
  const auto make = [context, attempt](const CheckedPath& best) {
    repair::StrategyResult result{best};
    if (std::ranges::none_of(best.findings, is_collision, &Finding::cause)) {
      result.stop_reason = "skipped (no collision left)";
      return result;
    }
    CheckedPath bridged{repair::bridge_collisions(*context.whole.robot, best, attempt.margin_s),
                        {}};
    bridged.findings = context.check(bridged.path);
    map::MapOptions options = context.options;
    options.movement_solver.relative_tolerance *= kCoarseToleranceFactor;
    const collision::CollisionWorld world = world_along(*context.whole.world, bridged.path);
    map::MappingProblem problem = with_clearance_weights(context.whole, {attempt.clearance});
    problem.world = &world;
    result.candidate.path = map::re_solve_path(problem, bridged.path, best.findings, options,
                                               attempt.margin_s + kReSolvedBesideBridge_s);
    result.candidate.findings = context.check(result.candidate.path);
    if (repair::is_better(bridged.findings, result.candidate.findings))
      result.candidate = std::move(bridged);
    return result;
  };
  return {fmt::format("margin {} s, clearance weight x {}", attempt.margin_s, attempt.clearance),
          make};
}

/// Returns the strategy that applies several strategies in order.
RepairStrategy chain(std::string name, std::vector<RepairStrategy> strategies) {
  return {std::move(name), [strategies = std::move(strategies)](const CheckedPath& best) {
            return repair::run_strategies(strategies, best);
          }};
}

RepairStrategy re_solve_from_bridges(const ReSolveContext& context) {
  std::vector<RepairStrategy> bridges;
  for (const BridgeAttempt& attempt : kBridgeAttempts)
    bridges.push_back(re_solve_bridge(context, attempt));
  return chain("re-solve from bridges over the collisions", std::move(bridges));
}

}  // namespace

map::MappingProblem whole_problem(const map::MappingProblem& problem,
                                  const collision::CollisionWorld& world) {
  map::MappingProblem whole = problem;
  whole.world = &world;
  if (map::is_hand_only(*world.robot)) whole.clearance.activation_distance_m *= kHandAloneBandScale;
  return whole;
}

std::vector<RepairStrategy> first_re_solves(const ReSolveContext& context) {
  if (map::is_hand_only(*context.whole.robot)) {
    return {chain("re-solve near the findings",
                  {re_solve_strategy(context, "clearance weight x 100, activation distance x 0.4",
                                     {100, 0.4}),
                   re_solve_strategy(context, "clearance weight x 10000, activation distance x 0.4",
                                     {10000, 0.4}),
                   re_solve_strategy(context, "clearance weight x 1000", {1000})}),
            re_solve_from_bridges(context)};
  }
  return {chain("re-solve, low clearance weights",
                {re_solve_strategy(context, "clearance weight x 10", {10}),
                 re_solve_strategy(context, "clearance weight x 100", {100})})};
}

RepairStrategy re_solve_strongly(const ReSolveContext& context) {
  return chain("re-solve, high clearance weights",
               {re_solve_strategy(context, "clearance weight x 1000", {1000}),
                re_solve_strategy(context, "clearance weight x 10000, activation distance x 0.2",
                                  {10000, 0.2}),
                re_solve_strategy(context, "tips and clearance only", kStrongestWeights, true)});
}

}  // namespace morphe::planning
