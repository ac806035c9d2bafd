#include "core/motion/missing_goals.hpp"

#include <algorithm>
#include <array>

namespace morphe {
namespace {

/// The goals that a part of a movement should have, and those that it lacks.
struct Count {
  std::size_t expected = 0, missing = 0;
  double share() const {
    return expected > 0 ? static_cast<double>(missing) / static_cast<double>(expected) : 0;
  }
};

/// Returns the tips with a goal of the person in at least one frame.
std::vector<std::size_t> followed_tips(const Goals& goals) {
  std::vector<std::size_t> tips;
  for (std::size_t tip = 0; tip < goals.tip_position.cols; ++tip) {
    if (!goals.auto_closed.empty() && goals.auto_closed[tip] != 0) continue;
    std::size_t frame = 0;
    while (frame < goals.frames() && !is_known(goals.tip_position(frame, tip))) ++frame;
    if (frame < goals.frames()) tips.push_back(tip);
  }
  return tips;
}

std::size_t index_of(PhaseKind kind) { return static_cast<std::size_t>(kind); }

/// Returns the phase to whose share a frame counts: a preshape is reach, a hold grasp.
PhaseKind counted_phase(const Movement& movement, double time_s) {
  if (is_grasping_at(movement, time_s)) return PhaseKind::grasp;
  const PhaseKind kind = main_phase_at(movement.phases, time_s);
  return kind == PhaseKind::preshape ? PhaseKind::reach : kind;
}

std::size_t missing_in(const Goals& goals, const std::vector<std::size_t>& tips,
                       std::size_t frame) {
  return static_cast<std::size_t>(std::ranges::count_if(
      tips, [&](std::size_t tip) { return !is_known(goals.tip_position(frame, tip)); }));
}

/// Sets the longest gap, between two neighbouring frames with goals or an end of the movement.
void find_longest_gap(const Goals& goals, const std::vector<std::size_t>& tips,
                      MissingGoals& result) {
  double seen_s = goals.time.empty() ? 0 : goals.time.front();
  bool in_gap = false;
  for (std::size_t frame = 0; frame < goals.frames(); ++frame) {
    const double time_s = goals.time[frame];
    const bool seen = missing_in(goals, tips, frame) < tips.size();
    if ((in_gap || !seen) && time_s - seen_s > result.gap_s) {
      result.gap_s = time_s - seen_s;
      result.gap_begin_s = seen_s;
      result.gap_end_s = time_s;
    }
    in_gap = !seen;
    if (seen) seen_s = time_s;
  }
}

}  // namespace

MissingGoals missing_goals(const Goals& goals, const Movement& movement) {
  MissingGoals result;
  const std::vector<std::size_t> tips = followed_tips(goals);
  if (tips.empty()) return result;
  find_longest_gap(goals, tips, result);
  std::array<Count, enum_count<PhaseKind>()> counts{};
  for (std::size_t frame = 0; frame < goals.frames(); ++frame) {
    Count& count = counts.at(index_of(counted_phase(movement, goals.time[frame])));
    count.expected += tips.size();
    count.missing += missing_in(goals, tips, frame);
  }
  result.grasp_share = counts.at(index_of(PhaseKind::grasp)).share();
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.at(k).share() <= result.phase_share) continue;
    result.phase_share = counts.at(k).share();
    result.phase = static_cast<PhaseKind>(k);
  }
  return result;
}

}  // namespace morphe
