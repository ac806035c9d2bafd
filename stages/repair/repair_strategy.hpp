#pragma once

#include <functional>
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

/// Returns true if the depths of the collisions have a smaller sum in `a` than in `b` or, if these
/// are equal, if the depths of all other findings have.
bool is_better(const std::vector<Finding>& a, const std::vector<Finding>& b);

/// Returns the deepest of the collisions or, without these, of the joint limits, then of the jumps,
/// then of the other findings; nullptr if there are no findings.
const Finding* worst_finding(const std::vector<Finding>& findings);

/// Returns true if no excess is above kNearlyFreeExcess, so that a re-solve may repair the path.
bool is_nearly_free(const std::vector<Finding>& findings);

/// The result of applying a strategy to the best path so far.
struct StrategyResult {
  CheckedPath candidate;         ///< another path, or the same
  PlanningFailure failure = {};  ///< the failure that stopped the strategy
  bool give_up = false;          ///< true if no other strategy can help
  std::string stop_reason = {};  ///< why the strategy ended or was skipped; "" without a reason
  std::vector<RepairStep> attempts = {};
};

/// A strategy for changing a path. Its result depends only on the path.
struct RepairStrategy {
  std::string name;
  std::function<StrategyResult(const CheckedPath& best)> make;
};

/// Returns the record of an attempt for the plan: its name, its effect on the path `from`, and
/// whether its result was `kept`.
RepairStep make_repair_step(std::string name, const CheckedPath& from, const StrategyResult& made,
                            bool kept);

/// Applies the strategies in order, each to the best path so far, while that has findings and none
/// gave up. A result is kept if it is better; of the others only a failure is. `attempts` of the
/// returned result holds the records of all strategies and of their attempts.
StrategyResult run_strategies(const std::vector<RepairStrategy>& strategies, CheckedPath start);

/// Returns the strategy, restricted to paths that are nearly free.
RepairStrategy only_if_nearly_free(RepairStrategy strategy);

/// The result of repairing a path.
struct RepairResult {
  JointPath path;
  bool repaired = false;           ///< true if the path has been changed and is free now
  std::vector<Finding> remaining;  ///< remaining findings of `path`
  std::vector<RepairStep> attempts;
};

/// Repairs a path with the strategies. Fails with the failure that stopped a strategy, otherwise
/// with the worst_finding() that remains.
Outcome<RepairResult> repair_path(const std::vector<RepairStrategy>& strategies, CheckedPath path);

/// Returns, for example, "no collision-free path in 3 attempts of 3000 iterations".
std::string no_path_message(const RepairOptions& options);

}  // namespace morphe::repair
