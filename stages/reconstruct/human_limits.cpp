#include "stages/reconstruct/human_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::reconstruct {

PlanningFailure check_human_limits(const HumanMotion& motion, const HumanOptions& human) {
  const auto found = std::ranges::find(motion.residuals, kLimitViolationResidual, &Residual::name);
  if (found == motion.residuals.end() || !(found->rms_m > human.max_limit_violation_m)) return {};
  return {Reason::implausible_arm,
          fmt::format("elbow and wrist are {:.0f} mm RMS beyond human joint limits "
                      "(human.max_limit_violation_m: {:.0f} mm)",
                      1000 * found->rms_m, 1000 * human.max_limit_violation_m)};
}

}  // namespace morphe::reconstruct
