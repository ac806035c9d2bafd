#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// A path and its findings.
struct CheckedPath {
  JointPath path;
  std::vector<Finding> findings;
};
/// A function that returns the findings of a path.
using PathCheck = std::function<std::vector<Finding>(const JointPath&)>;

/// Returns true if `a` is better than `b`: the sum of the depths of all collisions is less or, if
/// these are equal, that of all other findings.
bool is_better(const std::vector<Finding>& a, const std::vector<Finding>& b);

/// Returns the finding to report first: collisions, then limits, jumps, tips; the deepest of each.
/// Returns nullptr if there are no findings.
const Finding* worst_finding(const std::vector<Finding>& findings);

/// Returns true if solving again with higher weights may make the path free: no finding exceeds a
/// centimetre (limits and jumps: 0.01 rad).
bool is_nearly_free(const std::vector<Finding>& findings);

/// The result of applying a strategy to the best path so far: another path, or the same.
struct StrategyResult {
  CheckedPath candidate;                  ///< the resulting path
  PlanningFailure failure = {};           ///< the failure that stopped the strategy
  bool give_up = false;                   ///< true if no other strategy can help
  std::string stop_reason = {};           ///< reason for stopping
  std::vector<RepairStep> attempts = {};  ///< the strategy's attempts
};

/// A strategy for changing a path. Its result depends only on the path.
struct RepairStrategy {
  std::string name;
  std::function<StrategyResult(const CheckedPath& best)> make;
};

/// Returns the record of an attempt for the plan: its name and its effect on a path.
RepairStep make_repair_step(std::string name, const CheckedPath& from, const StrategyResult& made,
                            bool kept);

/// Applies the strategies in order while the path has findings; a strategy's result is kept if it
/// is better. The attempts of the result are all strategies, each with its own attempts below it.
StrategyResult run_strategies(const std::vector<RepairStrategy>& ladder, CheckedPath start);

/// Returns the strategy, restricted to paths that are nearly free.
RepairStrategy only_if_nearly_free(RepairStrategy rung);

/// The result of repairing a path.
struct RepairResult {
  JointPath path;
  bool repaired = false;           ///< true if the path has been changed and is free now
  std::vector<Finding> remaining;  ///< remaining findings of `path`
  std::vector<RepairStep> attempts;
};

/// Repairs a path with the strategies. Refuses with the failure that stopped a strategy or with the
/// worst remaining finding, collisions first. Reasons: start_in_collision, goal_in_collision,
/// unreachable, no_path, limit, jump, tracking.
Outcome<RepairResult> repair_path(const std::vector<RepairStrategy>& ladder, CheckedPath start);

/// Returns "no free path in 3 attempts of 3000 iterations", which states the effort of the search.
std::string no_path_message(const RepairOptions& options);

/// Returns "palm 4.0 mm too close to cup".
std::string excess_text(const Finding& finding);

/// Returns "palm is 4.0 mm too close to cup, 1.200–1.300 s".
std::string sentence(const Finding& finding);

}  // namespace morphe::repair
