#include "stages/certify/approximate_reason.hpp"

#include <fmt/format.h>

#include "core/motion/goal_interpolation.hpp"
#include "core/motion/missing_goals.hpp"

namespace morphe::certify {
namespace {

std::string reach_reason(const Goals& goals, const Tolerances& tolerances,
                         const Certificate& certificate) {
  const GoalCount count = count_goals(goals);
  const bool out_of_reach = count.share_out_of_reach() > tolerances.max_unreachable_share;
  const bool tip_too_far = certificate.tip_error_max > tolerances.max_tip_error;
  if (!out_of_reach && !tip_too_far) return "";
  return fmt::format(
      "{} of {} fingertip goals are out of reach (allowed: {:.0f} %); tips are up to {:.1f} mm "
      "from "
      "their goals (allowed: {:.1f} mm)",
      count.out_of_reach, count.all, 100 * tolerances.max_unreachable_share,
      1e3 * certificate.tip_error_max, 1e3 * tolerances.max_tip_error);
}

std::string share_reason(const MissingGoals& missing, const Tolerances& tolerances) {
  if (!(missing.phase_share > tolerances.max_missing_goal_share)) return "";
  return fmt::format("{:.0f} % of the fingertip goals of phase {} are missing (allowed: {:.0f} %)",
                     100 * missing.phase_share, name_of(missing.phase),
                     100 * tolerances.max_missing_goal_share);
}

std::string gap_reason(const MissingGoals& missing, const Tolerances& tolerances) {
  if (!(missing.gap_s > tolerances.max_goal_gap_s)) return "";
  return fmt::format("there is no fingertip goal for {:.2f} s, {:.2f}–{:.2f} s (allowed: {:.2f} s)",
                     missing.gap_s, missing.gap_begin_s, missing.gap_end_s,
                     tolerances.max_goal_gap_s);
}

}  // namespace

std::string approximate_reason(const Goals& goals, const Movement& movement,
                               const Tolerances& tolerances, const Certificate& certificate) {
  const MissingGoals missing = missing_goals(goals, movement);
  std::string text;
  for (const std::string& reason :
       {reach_reason(goals, tolerances, certificate), share_reason(missing, tolerances),
        gap_reason(missing, tolerances)})
    if (!reason.empty()) text += (text.empty() ? "approximate: " : "; ") + reason;
  return text;
}

}  // namespace morphe::certify
