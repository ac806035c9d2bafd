#include "stages/verify/transfer.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kStandsStill_s = 1e-9;

}  // namespace

void judge_transfer(const Plan& plan, const Trajectory& motion, Transfer which, const Asked* asked,
                    ViolationRuns& runs) {
  const bool approach = which == Transfer::approach;
  const std::vector<double>& way = plan.trajectory.demonstration_time;
  const double stands_s = approach ? way.front() : way.back();
  for (const double time_s : motion.demonstration_time) {
    if (std::abs(time_s - stands_s) <= kStandsStill_s) continue;
    runs.note_plan("transfer", "demonstration_time", time_s, stands_s);
    break;
  }
  const auto other =
      std::ranges::find_if(motion.phase, [](PhaseKind phase) { return phase != PhaseKind::rest; });
  if (other != motion.phase.end())
    runs.note_plan("transfer", "phase", static_cast<double>(*other),
                   static_cast<double>(PhaseKind::rest));
  if (!asked || !asked->home || asked->home->posture.size() != motion.position.cols()) return;
  const Eigen::Index end = approach ? 0 : motion.position.rows() - 1;
  const double off =
      (motion.position.row(end).transpose() - asked->home->posture).cwiseAbs().maxCoeff();
  if (!(off <= kTransferEnd)) runs.note_plan("transfer", "home", off, kTransferEnd);
}

void judge_share(const LimitUse& use, double share, ViolationRuns& runs) {
  constexpr double kRelative = 1e-6;
  const auto holds = [&](const char* name, double ratio) {
    if (!(ratio <= share * (1 + kRelative))) runs.note_plan("config", name, ratio, share);
  };
  holds("velocity_ratio", use.velocity_ratio);
  holds("acceleration_ratio", use.acceleration_ratio);
  holds("jerk_ratio", use.jerk_ratio);
}

}  // namespace morphe::verify
