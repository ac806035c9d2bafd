#include "stages/certify/approximate_reason.hpp"

#include <fmt/format.h>

#include "core/motion/goal_interpolation.hpp"

namespace morphe::certify {

std::string approximate_reason(const Goals& goals, const Tolerances& tolerances,
                               const Certificate& certificate) {
  const GoalCount count = count_goals(goals);
  const bool out_of_reach = count.share_out_of_reach() > tolerances.max_unreachable_share;
  const bool tip_too_far = certificate.tip_error_max > tolerances.max_tip_error;
  if (!out_of_reach && !tip_too_far) return "";
  return fmt::format(
      "approximate: {} of {} fingertip goals are out of reach (allowed: {:.0f} %); tips are up to "
      "{:.1f} mm from their goals (allowed: {:.1f} mm)",
      count.out_of_reach, count.all, 100 * tolerances.max_unreachable_share,
      1e3 * certificate.tip_error_max, 1e3 * tolerances.max_tip_error);
}

}  // namespace morphe::certify
