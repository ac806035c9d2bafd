#include "stages/verify/approach_retreat.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kFrozenClockTolerance_s = 1e-9;

}  // namespace

void verify_approach_retreat(const Plan& plan, const Trajectory& motion, ApproachOrRetreat which,
                             const PlanRequest* asked, ViolationCollector& runs) {
  const bool approach = which == ApproachOrRetreat::approach;
  const std::vector<double>& way = plan.trajectory.demonstration_time;
  const double stands_s = approach ? way.front() : way.back();
  for (const double time_s : motion.demonstration_time) {
    if (std::abs(time_s - stands_s) <= kFrozenClockTolerance_s) continue;
    runs.note_plan("approach_retreat", "demonstration_time", time_s, stands_s);
    break;
  }
  const auto other =
      std::ranges::find_if(motion.phase, [](PhaseKind phase) { return phase != PhaseKind::rest; });
  if (other != motion.phase.end())
    runs.note_plan("approach_retreat", "phase", static_cast<double>(*other),
                   static_cast<double>(PhaseKind::rest));
  if (!asked || !asked->home || asked->home->posture.size() != motion.position.cols()) return;
  const Eigen::Index end = approach ? 0 : motion.position.rows() - 1;
  const double off =
      (motion.position.row(end).transpose() - asked->home->posture).cwiseAbs().maxCoeff();
  if (!(off <= kJunctionTolerance))
    runs.note_plan("approach_retreat", "home", off, kJunctionTolerance);
}

void verify_limit_scaling(const LimitUse& use, double share, ViolationCollector& runs) {
  constexpr double kShareTolerance = 1e-6;
  const auto holds = [&](const char* name, double ratio) {
    if (!(ratio <= share * (1 + kShareTolerance))) runs.note_plan("config", name, ratio, share);
  };
  holds("velocity_ratio", use.velocity_ratio);
  holds("acceleration_ratio", use.acceleration_ratio);
  holds("jerk_ratio", use.jerk_ratio);
}

}  // namespace morphe::verify
