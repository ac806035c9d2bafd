#include "pipeline/explain/step_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/arm_estimate.hpp"
#include "core/motion/assumption_text.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/finding_text.hpp"
#include "core/motion/flag_text.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "pipeline/explain/reasons.hpp"
#include "pipeline/planning/palm_error.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::explain {
namespace {

std::string line(std::string_view step, const std::string& text) {
  return fmt::format("  {:<13} {}\n", step, text);
}

std::string segmentation(const Movement& movement) {
  const std::string target =
      movement.target.empty() ? "no object grasped" : "target " + movement.target;
  std::string text = line("segmentation", fmt::format("{:.2f}–{:.2f} s of the recording, {}",
                                                      movement.begin_s, movement.end_s, target));
  for (const Phase& phase : movement.phases)
    text += line("", fmt::format("{:<9} {:6.2f}–{:.2f} s, confidence {:.0f} %", name_of(phase.kind),
                                 phase.begin_s, phase.end_s, 100 * phase.confidence));
  return text;
}

/// Returns the time intervals of frames whose goals are out of reach, "1.20–1.80 s, 2.10–2.30 s".
std::string intervals_out_of_reach(const MappingResult& mapped, const std::vector<double>& time) {
  std::string text;
  const std::vector<FrameStatus>& status = mapped.status;
  for (int first = 0, last = 0; first < std::ssize(status); first = last + 1) {
    last = first;
    if (status[first] != FrameStatus::out_of_reach) continue;
    while (last + 1 < std::ssize(status) && status[last + 1] == FrameStatus::out_of_reach) ++last;
    text += fmt::format("{}{:.2f}–{:.2f} s", text.empty() ? "" : ", ", time[first], time[last]);
  }
  return text;
}

/// Sum, maximum and number of the values that are not NaN.
struct Statistics {
  double sum = 0, max = 0, count = 0;
};
Statistics statistics_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
  Statistics known;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    known.sum += value;
    known.max = std::max(known.max, value);
    known.count += 1;
  }
  return known;
}

std::string tip_error_text(const RobotModel& robot, const MappingResult& mapped) {
  std::string text;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const Statistics error = statistics_of(mapped.tip_error.col(tip));
    if (error.count == 0) continue;
    text += fmt::format("{}{} {:.1f} (max {:.1f})", text.empty() ? "" : ", ", robot.tips[tip].name,
                        kMillimetresPerMetre * error.sum / error.count,
                        kMillimetresPerMetre * error.max);
  }
  return text;
}

std::string mapping(const RobotModel& robot, const Plan& plan) {
  const MappingResult& mapped = plan.mapped;
  if (mapped.position.rows() == 0) return line("mapping", "no frames were mapped");
  std::string text = line("mapping", fmt::format("{}; mean distance from the goals in mm: {}",
                                                 count_with_noun(mapped.status.size(), "frame"),
                                                 tip_error_text(robot, mapped)));
  const GoalCount count = count_goals(plan.goals);
  const std::string intervals = intervals_out_of_reach(mapped, plan.goals.time);
  text += line("", fmt::format("{} of {} fingertip goals out of reach{}{}", count.out_of_reach,
                               count.all, intervals.empty() ? "" : ": ", intervals));
  Statistics arm;
  if (mapped.humanlikeness.cols() > 0) arm = statistics_of(mapped.humanlikeness.col(0));
  const double a = arm.count > 0 ? arm.sum / arm.count : kUnknown;
  const double palm = planning::palm_error(robot, plan);
  std::string human;
  if (!std::isnan(a))
    human = is_arm_estimated(plan.goals)
                ? fmt::format("humanlikeness A ~{:.4f} m^2 from an estimated shoulder and elbow", a)
                : fmt::format("humanlikeness A {:.4f} m^2", a);
  if (!std::isnan(palm))
    human += fmt::format("{}palm rotated by {:.0f} degrees from the person's",
                         human.empty() ? "" : ", ", palm / kRadPerDegree);
  return human.empty() ? text : text + line("", human);
}

/// Returns the branch of the arm, with its changes along the path; "" without one.
std::string branch_line(const ArmBranch& branch) {
  if (!branch.number) return "";
  std::string text = fmt::format("{}", fmt::join(branch.words, ", "));
  if (!branch.changes.empty()) text += fmt::format("; {}", fmt::join(branch.changes, ", "));
  return line("branch", text);
}

std::string finding_lines(const char* step, const std::vector<Finding>& findings,
                          const char* none) {
  if (findings.empty()) return line(step, none);
  std::string text;
  for (const Finding& finding : findings) text += line(text.empty() ? step : "", sentence(finding));
  return text;
}

std::string flag_lines(const std::vector<RecordingFlag>& flags) {
  std::string text;
  for (const RecordingFlag& flag : flags) text += line(text.empty() ? "flags" : "", sentence(flag));
  return text;
}

std::string change_text(const RobotModel& robot, const RepairStep& step) {
  if (std::isnan(step.begin_s)) return step.stop_reason.empty() ? "no change" : step.stop_reason;
  return fmt::format("joints changed by up to {:.3f} {}, {:.2f}–{:.2f} s", step.max_joint_change,
                     robot.has_prismatic_joint() ? "rad or m" : "rad", step.begin_s, step.end_s);
}

/// Returns true for plans of earlier versions, which do not record the repair steps.
bool lacks_repair_record(const Plan& plan) { return plan.repair.empty() && !plan.findings.empty(); }

std::string repairs(const RobotModel& robot, const Plan& plan) {
  const std::vector<RepairStep>& steps = plan.repair;
  if (lacks_repair_record(plan))
    return line("repair", "not recorded: the file is from an earlier version");
  if (steps.empty()) return line("repair", "nothing to repair");
  std::string text;
  for (const RepairStep& step : steps) {
    std::string what =
        fmt::format("{}{}: {}", step.level > 0 ? "  " : "", step.name, change_text(robot, step));
    if (!std::isnan(step.begin_s)) {
      what += step.finding_count == 0
                  ? ", no problems left"
                  : fmt::format(", {} left, worst: {}",
                                count_with_noun(step.finding_count, "problem"), step.worst_finding);
      what += step.accepted ? "; accepted" : "; rejected";
    }
    if (!std::isnan(step.begin_s) && !step.stop_reason.empty()) what += "; " + step.stop_reason;
    text += line(text.empty() ? "repair" : "", what);
  }
  return text;
}

std::string certificate(const Certificate& c) {
  std::string text;
  const auto add = [&](const char* name, double value, int digits, const char* unit) {
    if (std::isnan(value)) return;
    text += fmt::format("{}{} {:.{}f}{}", text.empty() ? "" : ", ", name, value, digits, unit);
  };
  add("velocity", c.velocity_ratio, 2, "");
  add("acceleration", c.acceleration_ratio, 2, "");
  add("jerk", c.jerk_ratio, 2, " of their limits");
  add("clearance", kMillimetresPerMetre * c.clearance, 2, " mm");
  add("tip error at most", kMillimetresPerMetre * c.tip_error_max, 2, " mm");
  add("in the grasp at most", kMillimetresPerMetre * c.tip_error_grasp, 2, " mm");
  std::string lines = line("certificate", text.empty() ? "none" : text);
  if (!c.clearance_by_kind.empty()) lines += line("clearance", clearance_phrase(c));
  return lines;
}

std::string timing(const Plan& plan) {
  if (!plan.has_trajectory()) {
    const bool free = plan.path.position.rows() > 0 && plan.remaining_findings.empty() &&
                      !lacks_repair_record(plan);
    return line("time law", free ? "the path is valid, but the plan failed: see the reason above"
                                 : "skipped: the path still has problems");
  }
  return line("time law",
              fmt::format("{:.2f} s, {:.2f} times the person's duration",
                          plan.trajectory.time.back(), plan.certificate.duration_ratio));
}

}  // namespace

std::string step_summary(const RobotModel& robot, const Plan& plan) {
  std::string text =
      fmt::format("{}/{:03}: {}", plan.demonstration, plan.movement.index, name_of(plan.status()));
  if (plan.reason != Reason::none)
    text += fmt::format(", {}. {}", name_of(plan.reason), explanation_of(plan.reason).sentence);
  text += "\n";
  if (!plan.detail.empty()) text += line("", plan.detail);
  text += flag_lines(plan.flags);
  if (plan.reason == Reason::no_movement) return text;
  text += segmentation(plan.movement) + mapping(robot, plan);
  if (plan.mapped.position.rows() == 0) return text;
  text += branch_line(plan.branch);
  text += finding_lines("problems", plan.findings, "none in the mapped path");
  text += repairs(robot, plan);
  if (!plan.remaining_findings.empty())
    text += finding_lines("remaining", plan.remaining_findings, "");
  return text + timing(plan) + certificate(plan.certificate);
}

}  // namespace morphe::explain
