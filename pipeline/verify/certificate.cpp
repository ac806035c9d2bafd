#include "pipeline/verify/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::judge {

void judge_certificate(const Plan& plan, const LimitUse& use, double clearance,
                       double position_error_max, ViolationRuns& runs) {
  const Certificate& stored = plan.certificate;
  const auto agree = [&](const char* name, double value, double recomputed, double tolerance) {
    if (std::isnan(value) && std::isnan(recomputed)) return;
    if (!(std::abs(value - recomputed) <= tolerance))
      runs.note_plan("certificate", name, value, recomputed);
  };
  const auto agree_in_ratio = [&](const char* name, double value, double recomputed) {
    agree(name, value, recomputed, 1e-4 * std::max(std::abs(recomputed), 1e-6));
  };
  agree("position_margin", stored.position_margin, use.position_margin, 1e-6);
  agree_in_ratio("velocity_ratio", stored.velocity_ratio, use.velocity_ratio);
  agree_in_ratio("acceleration_ratio", stored.acceleration_ratio, use.acceleration_ratio);
  agree_in_ratio("jerk_ratio", stored.jerk_ratio, use.jerk_ratio);
  agree("position_error_max", stored.position_error_max, position_error_max, 1e-4);
  agree_in_ratio("tempo", stored.tempo,
                 plan.trajectory.time.back() / (plan.movement.end_s - plan.movement.begin_s));
  // Nothing that could touch: any value, or none, is as true.
  const bool unbounded = std::isinf(clearance);
  if (!unbounded && !(stored.clearance <= clearance + 1e-4))
    runs.note_plan("certificate", "clearance", stored.clearance, clearance);
}

}  // namespace morphe::judge
