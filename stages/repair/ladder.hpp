#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// A path and everything that is wrong with it.
struct Checked {
  JointPath path;
  std::vector<Finding> findings;
};
using Check = std::function<std::vector<Finding>(const JointPath&)>;

/// The order by which repair decides: the depths of all collisions together; where these are equal,
/// those of everything else.
bool less_bad(const std::vector<Finding>& a, const std::vector<Finding>& b);

/// What is spoken of first: collisions, then limits, jumps, tips; the deepest of each. nullptr:
/// there is none.
const Finding* worst_of(const std::vector<Finding>& findings);

/// So near to free that firmer re-solving may make it so: nothing by more than a centimetre (limits
/// and jumps: 0.01 rad).
bool nearly_free(const std::vector<Finding>& findings);

/// What a rung made of the best path so far: another one, or the same.
struct Made {
  Checked checked;
  Refusal refusal = {};                ///< what stopped the rung
  bool last = false;                   ///< no other rung can help
  std::string ended = {};              ///< why it went no further
  std::vector<RepairStep> steps = {};  ///< its attempts
};

/// One way to change a path. It depends on the path alone.
struct Rung {
  std::string name;
  std::function<Made(const Checked& best)> make;
};

/// What an attempt named so made of a path, for the plan's record.
RepairStep step_of(std::string name, const Checked& from, const Made& made, bool kept);

/// The rungs one after the other, as long as something is wrong: what a rung made is kept if it is
/// less bad. The steps of what comes back are all rungs, each with its attempts below it.
Made climb(const std::vector<Rung>& ladder, Checked start);

/// The rung for paths that are nearly free, for no others.
Rung if_nearly_free(Rung rung);

struct RepairResult {
  JointPath path;
  bool repaired = false;           ///< the path has changed, and is free now
  std::vector<Finding> remaining;  ///< what is still wrong with `path`
  std::vector<RepairStep> steps;
};

/// Climbs, and says what is left: what stopped a rung, or the worst finding, collisions first.
/// Refused: start_in_collision, goal_in_collision, unreachable, no_path, limit, jump, tracking.
Outcome<RepairResult> repair_path(const std::vector<Rung>& ladder, Checked start);

/// "no free path in 3 attempts of 3000 iterations": how long a way around was looked for.
std::string no_free_path(const RepairOptions& options);

/// "object: palm – cup from 1.200 s to 1.300 s, 0.0040 m too much".
std::string sentence(const Finding& finding);

}  // namespace morphe::repair
