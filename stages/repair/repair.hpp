#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/collision/certified.hpp"
#include "pipeline/motion/plan.hpp"

namespace morphe::repair {

/// `rrt_connect` is a baseline: all joints at once and shortcuts alone.
enum class Method { humanlike, rrt_connect };
constexpr std::array<std::string_view, 2> names_of(Method) { return {"humanlike", "rrt_connect"}; }

struct RepairOptions {
  Method method = Method::humanlike;
  int attempts = 3;             ///< times the planner is tried, each wider than the last
  int iterations = 3000;        ///< of the planner in one attempt at one interval
  int widen_samples = 20;       ///< added on each side of a finding, once more each attempt
  double range = 0.1;           ///< longest step of the planner, in shares of a joint's span
  int shortcut_attempts = 100;  ///< straight lines tried through a planned interval
  int draw_attempts = 200;      ///< windows of it drawn back to the original path
  int searches = 3;  ///< of other courses for the whole movement, where the first leads nowhere
  double extra_clearance = 0.005;  ///< planned with this much more than the margin [m]
};
template <class Fields>
void fields(Fields& f, RepairOptions& o) {
  f("method", o.method);
  f("attempts", o.attempts);
  f("iterations", o.iterations);
  f("widen_samples", o.widen_samples);
  f("range", o.range);
  f("shortcut_attempts", o.shortcut_attempts);
  f("draw_attempts", o.draw_attempts);
  f("searches", o.searches);
  f("extra_clearance", o.extra_clearance);
}
std::string why_invalid(const RepairOptions& options);

struct RepairResult {
  JointPath path;
  bool repaired = false;  ///< the path has changed, and is free now
  /// none: free; or start_in_collision, goal_in_collision, unreachable, no_path, limit, jump,
  /// tracking
  Reason reason = Reason::none;
  std::string detail;              ///< a sentence that names the finding
  std::vector<Finding> remaining;  ///< what the last check of `path` still found
};

/// A time of a movement for which no posture is good enough.
struct DeadEnd {
  Reason reason = Reason::unreachable;  ///< obstacles or not; or goal_in_collision
  double time_s = 0;                    ///< demonstration time
  int tried = 0;                        ///< postures that were looked at
  Finding nearest;                      ///< what is wrong with the best of them
};

/// Whether a path is so near to free that firmer re-solving may make it so.
bool worth_insisting(const std::vector<Finding>& findings);

/// What repair asks of the mapping and of the judge; all but `recheck` may be empty.
struct RepairSteps {
  /// Solves the mapping again near the findings, with a clearance term; the changed samples carry
  /// Origin::resolved.
  std::function<JointPath(const JointPath& path, const std::vector<Finding>& findings)> resolve;
  /// The same, as firmly as it takes, for what `resolve` leaves.
  std::function<JointPath(const JointPath& path, const std::vector<Finding>& findings)> insist;
  /// The best of `path` and the mapping's other candidates for it, these solved alike.
  std::function<JointPath(const JointPath& path, const std::vector<Finding>& findings)> candidates;
  /// The judge: all findings of a path.
  std::function<std::vector<Finding>(const JointPath& path)> recheck;
  /// Another course through the whole movement, searched with the whole scene in sight: other ways
  /// to hold the same goals (a goal set), for a path whose end is bad or that leads nowhere. The
  /// most humanlike first; none: there is no other. `nearer`: the last one became the best.
  std::function<std::optional<JointPath>(bool nearer)> new_course;
  /// Whether any posture is good enough at the times of the findings. Where none is, no search for
  /// paths can help.
  std::function<std::optional<DeadEnd>(const JointPath& path, const std::vector<Finding>& findings)>
      dead_end;
};

/// The smallest change that makes a path free, the least first: (1) what `resolve` gives, and
/// nothing more if that leaves a `dead_end`; then what `insist` and `candidates` give; (2) around
/// each collision that is left, an RRT-Connect between the nearest free samples with certified
/// edges, the arm first and the fingers in proportion, then all joints; shortened, spread over the
/// interval's samples and drawn back to the original path as far as it stays free; what that costs
/// in tracking goes to `resolve` once more, and to `insist` if that is worth it; (3) both again
/// from each `new_course`. A step is kept if `recheck` finds less than before. Samples outside the
/// intervals keep their bits in (1) and (2); those that went through the planner are
/// Origin::planned. `reach` is capsule_reach(); `findings` are those of `path`. Depends on its
/// arguments alone.
RepairResult repair_path(const collision::CollisionWorld& world, const JointRows& reach,
                         JointPath path, std::vector<Finding> findings, const RepairSteps& steps,
                         const RepairOptions& options, std::uint64_t seed);

}  // namespace morphe::repair
