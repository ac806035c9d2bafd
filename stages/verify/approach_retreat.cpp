#include "stages/verify/approach_retreat.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kStillClockTolerance_s = 1e-9;

}  // namespace

void verify_approach_retreat(const Plan& plan, const Trajectory& motion, ApproachOrRetreat kind,
                             const PlanRequest* request, ViolationLog& violations) {
  const bool approach = kind == ApproachOrRetreat::approach;
  const std::vector<double>& clock = plan.trajectory.demonstration_time;
  const double junction_s = approach ? clock.front() : clock.back();
  for (const double time_s : motion.demonstration_time) {
    if (std::abs(time_s - junction_s) <= kStillClockTolerance_s) continue;
    violations.note_plan("approach_retreat", "demonstration_time", time_s, junction_s);
    break;
  }
  for (const PhaseKind phase : motion.phase) {
    // Files of earlier versions say rest.
    if (phase == (approach ? PhaseKind::approach : PhaseKind::retreat) || phase == PhaseKind::rest)
      continue;
    violations.note_plan("approach_retreat", "phase", static_cast<double>(phase),
                         static_cast<double>(PhaseKind::rest));
    break;
  }
  if (!request || !request->home) return;
  const JointVector& home = request->home->posture;
  if (home.size() != motion.position.cols()) return;
  const Eigen::Index end = approach ? 0 : motion.position.rows() - 1;
  const double deviation = (motion.position.row(end).transpose() - home).cwiseAbs().maxCoeff();
  if (!(deviation <= kJunctionTolerance))
    violations.note_plan("approach_retreat", "home", deviation, kJunctionTolerance);
}

void verify_limit_scaling(const LimitUse& use, double limit_scaling, ViolationLog& violations) {
  constexpr double kShareTolerance = 1e-6;
  const auto check = [&](const char* name, double ratio) {
    if (!(ratio <= limit_scaling * (1 + kShareTolerance)))
      violations.note_plan("config", name, ratio, limit_scaling);
  };
  check("velocity_ratio", use.velocity_ratio);
  check("acceleration_ratio", use.acceleration_ratio);
  check("jerk_ratio", use.jerk_ratio);
}

}  // namespace morphe::verify
