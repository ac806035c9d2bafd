#include "stages/certify/approximate_reason.hpp"

#include <fmt/format.h>

#include "core/motion/goal_interpolation.hpp"

namespace morphe::certify {

std::string approximate_reason(const Goals& goals, const Tolerances& tolerances,
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
