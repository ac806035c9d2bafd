#include <fmt/format.h>

#include "core/motion/missing_goals.hpp"
#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

RecordingFlag missing_share(const AuditedMovement& audited, double share, double limit) {
  RecordingFlag flag{.code = FlagCode::missing_goals, .value = share, .limit = limit, .unit = "1"};
  flag.begin_s = audited.movement.begin_s;
  flag.end_s = audited.movement.end_s;
  flag.text = fmt::format(
      "{:.0f} % of the fingertip goals in grasp and hold were not recorded (allowed: {:.0f} %): "
      "fill "
      "the gaps of the fingertips, or accept missing_goals",
      100 * share, 100 * limit);
  return flag;
}

RecordingFlag long_gap(const MissingGoals& missing, double limit_s) {
  RecordingFlag flag{.code = FlagCode::missing_goals,
                     .begin_s = missing.gap_begin_s,
                     .end_s = missing.gap_end_s,
                     .value = missing.gap_s,
                     .limit = limit_s,
                     .unit = "s"};
  flag.text = fmt::format(
      "no fingertip was recorded for {:.2f} s, {:.2f}–{:.2f} s (allowed: {:.2f} s): fill the gap, "
      "or "
      "accept missing_goals",
      flag.value, flag.begin_s, flag.end_s, limit_s);
  return flag;
}

}  // namespace

std::vector<RecordingFlag> check_goals(const AuditedMovement& audited,
                                       const AuditOptions& options) {
  const MissingGoals missing = missing_goals(audited.goals, audited.movement);
  std::vector<RecordingFlag> flags;
  if (missing.grasp_share > options.max_missing_goal_share)
    flags.push_back(missing_share(audited, missing.grasp_share, options.max_missing_goal_share));
  if (missing.gap_s > options.max_goal_gap_s)
    flags.push_back(long_gap(missing, options.max_goal_gap_s));
  return flags;
}

}  // namespace morphe::imports
