#include "stages/reconstruct/human_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::reconstruct {

PlanningFailure check_human_limits(const HumanMotion& motion, const HumanOptions& human) {
  const auto found = std::ranges::find(motion.residuals, kLimitViolationResidual, &Residual::name);
  if (found == motion.residuals.end() || !(found->rms_m > human.beyond_limits_m)) return {};
  return {Reason::not_human,
          fmt::format("elbow and wrist lie {:.0f} mm RMS beyond human joint limits, more than "
                      "human.beyond_limits_m, {:.0f} mm",
                      1000 * found->rms_m, 1000 * human.beyond_limits_m)};
}

}  // namespace morphe::reconstruct
