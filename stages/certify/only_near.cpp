#include "stages/certify/only_near.hpp"

#include <fmt/format.h>

#include "core/motion/goals_at.hpp"

namespace morphe::certify {

std::string only_near(const Goals& goals, const Tolerances& tolerances,
                      const Certificate& certificate) {
  const GoalCount count = count_goals(goals);
  const bool out_of_reach = count.share_out_of_reach() > tolerances.out_of_reach_share;
  const bool far = certificate.position_error_max > tolerances.farthest_tip;
  if (!out_of_reach && !far) return "";
  return fmt::format(
      "approximate: {} of {} fingertip goals are out of reach, {:.0f} % allowed; "
      "tips are up to {:.1f} mm from their goals, {:.1f} allowed",
      count.out_of_reach, count.all, 100 * tolerances.out_of_reach_share,
      1e3 * certificate.position_error_max, 1e3 * tolerances.farthest_tip);
}

}  // namespace morphe::certify
