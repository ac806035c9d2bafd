#include "stages/verify/missing_goals.hpp"

#include <algorithm>
#include <map>

#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

/// The number of goals of a phase, missing ones included, and of the missing ones.
struct PhaseGoals {
  double all = 0, missing = 0;
};

bool is_of_person(const Goals& goals, std::size_t tip) {
  if (!goals.auto_closed.empty() && goals.auto_closed[tip] != 0) return false;
  for (std::size_t f = 0; f < goals.tip_position.rows; ++f)
    if (is_known(goals.tip_position(f, tip))) return true;
  return false;
}

PhaseKind merged_phase(const std::vector<Phase>& phases, double time_s) {
  if (is_grasping(phases, time_s)) return PhaseKind::grasp;
  const PhaseKind own = main_phase_at(phases, time_s);
  return own == PhaseKind::preshape ? PhaseKind::reach : own;
}

double longest_step_with_gap(const std::vector<double>& time, const std::vector<bool>& has_goal) {
  std::vector<std::size_t> ends{0};
  for (std::size_t f = 0; f < time.size(); ++f)
    if (has_goal[f]) ends.push_back(f);
  ends.push_back(time.size() - 1);
  double longest_s = 0;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const bool neighbours = ends[k] - ends[k - 1] <= 1;
    if (neighbours && has_goal[ends[k - 1]] && has_goal[ends[k]]) continue;
    longest_s = std::max(longest_s, time[ends[k]] - time[ends[k - 1]]);
  }
  return longest_s;
}

}  // namespace

GoalGaps find_goal_gaps(const Plan& plan) {
  const Goals& goals = plan.goals;
  if (goals.time.empty()) return {};
  std::map<PhaseKind, PhaseGoals> by_phase;
  std::vector<bool> has_goal(goals.time.size(), false);
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
    if (!is_of_person(goals, tip)) continue;
    for (std::size_t f = 0; f < goals.time.size(); ++f) {
      PhaseGoals& own = by_phase[merged_phase(plan.movement.phases, goals.time[f])];
      own.all += 1;
      if (is_known(goals.tip_position(f, tip))) {
        has_goal[f] = true;
      } else {
        own.missing += 1;
      }
    }
  }
  if (by_phase.empty()) return {};
  GoalGaps gaps;
  for (const auto& [kind, own] : by_phase)
    gaps.largest_share = std::max(gaps.largest_share, own.missing / own.all);
  gaps.longest_s = longest_step_with_gap(goals.time, has_goal);
  return gaps;
}

}  // namespace morphe::verify
