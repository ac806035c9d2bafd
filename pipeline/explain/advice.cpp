#include "pipeline/explain/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "core/motion/goal_interpolation.hpp"
#include "pipeline/explain/path_violations.hpp"

namespace morphe::explain {
namespace {

constexpr double kSmoothingAllowance_m = 3e-4;  ///< error added by smoothing and certificate
constexpr double kReplanAllowanceShare = 0.05;  ///< of the error, because a new plan differs

/// Returns the tolerance for an error and both allowances, rounded up to half a millimetre.
double tolerance_for(double error_m) {
  return std::ceil(2e3 * ((1 + kReplanAllowanceShare) * error_m + kSmoothingAllowance_m)) / 2e3;
}

std::string violation_text(const TipError& error) {
  return fmt::format("{} is {:.1f} mm from its goal at {:.2f} s{} (allowed: {:.1f} mm)", error.tip,
                     kMillimetresPerMetre * error.error_m, error.time_s,
                     error.grasping ? " in the grasp" : "", kMillimetresPerMetre * error.allowed_m);
}

std::string violation_text(const ClearanceViolation& contact) {
  const double distance_m = contact.required_m - contact.lacking_clearance_m;
  const std::string requirement =
      contact.config_key != "check.required_clearance"
          ? fmt::format("allowed: {:.1f} mm", -kMillimetresPerMetre * contact.required_m)
          : fmt::format("required distance: {:.1f} mm", kMillimetresPerMetre * contact.required_m);
  const double distance_mm = kMillimetresPerMetre * std::abs(distance_m);
  const std::string distance = distance_m < 0 ? fmt::format("overlap by {:.1f} mm", distance_mm)
                                              : fmt::format("are {:.1f} mm apart", distance_mm);
  return fmt::format("{} and {} {}, {:.2f}–{:.2f} s ({})", contact.first, contact.second, distance,
                     contact.begin_s, contact.end_s, requirement);
}

/// Appends the settings of margin and depths that permit all contacts; there must be a contact.
/// Returns the worst contact as text, or "" if no margin above 0.1 mm permits them.
std::string relax_contact_tolerances(const PathViolations& violations,
                                     std::vector<std::string>& settings) {
  double margin_m = kUnknown;
  std::map<std::string_view, double> depths_m;
  for (const ClearanceViolation& contact : violations.contacts) {
    const double distance_m = contact.required_m - contact.lacking_clearance_m;
    if (contact.config_key == "check.required_clearance") {
      margin_m = std::fmin(margin_m, distance_m);
    } else {
      double& depth_m = depths_m.emplace(contact.config_key, 0).first->second;
      depth_m = std::max(depth_m, -distance_m);
    }
  }
  if (margin_m < 1e-4) return "";
  if (!std::isnan(margin_m)) {
    settings.push_back(
        fmt::format("check.required_clearance={:.4f}", std::floor(1e4 * margin_m - 0.5) / 1e4));
  }
  for (const auto& [key, depth_m] : depths_m)
    settings.push_back(fmt::format("{}={:.4f}", key, tolerance_for(depth_m)));
  return violation_text(violations.contacts.front());
}
void add_relaxed(const Plan& plan, const PathViolations& violations, std::vector<Advice>& advice) {
  if (!violations.jumps.empty() || !violations.limits.empty()) return;
  Advice accept{AdviceKind::relaxes_tolerance, {}, ""};
  std::vector<std::string> errors;
  double max_tolerance_m = 0;
  const auto allow = [&](const char* key, const std::optional<TipError>& miss) {
    if (!miss) return;
    const double tolerance_m = tolerance_for(miss->error_m);
    max_tolerance_m = std::max(max_tolerance_m, tolerance_m);
    accept.settings.push_back(fmt::format("{}={:.4f}", key, tolerance_m));
    errors.push_back(violation_text(*miss));
  };
  allow("check.tracking_tolerance_grasp", violations.grasp_tip_error);
  allow("check.tracking_tolerance", violations.other_tip_error);
  if (!violations.contacts.empty()) {
    const std::string contact = relax_contact_tolerances(violations, accept.settings);
    if (contact.empty()) {
      advice.push_back({AdviceKind::changes_input,
                        {},
                        fmt::format("{}: no tolerance can allow this; change their shapes, the "
                                    "scene or the position of the base",
                                    violation_text(violations.contacts.front()))});
      return;
    }
    errors.push_back(contact);
  }
  if (accept.settings.empty()) return;
  accept.sentence = fmt::format("{}; the error stays", fmt::join(errors, "; "));
  if (max_tolerance_m > plan.tolerances.max_tip_error)
    accept.sentence +=
        fmt::format("; errors above check.max_tip_error ({:.1f} mm) give the status approximate",
                    kMillimetresPerMetre * plan.tolerances.max_tip_error);
  advice.push_back(std::move(accept));
}

std::string reach_sentence(const Plan& plan) {
  const GoalCount count = count_goals(plan.goals);
  const std::string goals =
      count.out_of_reach == 0
          ? ""
          : fmt::format("{} of {} fingertip goals are out of reach from this base position; ",
                        count.out_of_reach, count.all);
  return goals +
         "the base may move by up to 100 mm, separately for each movement (`morphe place` "
         "searches for one position for all)";
}

void add_for_reason(const Plan& plan, std::vector<Advice>& advice) {
  const auto change = [&](const char* sentence) {
    advice.push_back({AdviceKind::changes_input, {}, sentence});
  };
  const auto relax = [&](std::vector<std::string> settings, const char* sentence) {
    advice.push_back({AdviceKind::relaxes_tolerance, std::move(settings), sentence});
  };
  switch (plan.reason) {
    case Reason::no_movement:
      change(
          "the recording must contain a complete reach, from rest to rest; `morphe inspect` shows "
          "what was found in it");
      return relax({"segment.whole_recording=true"}, "the whole recording becomes one movement");
    case Reason::no_shoulder:
      return change(
          "the shoulder must be seen at least once: record markers or sensors of shoulder, elbow "
          "and wrist");
    case Reason::implausible_arm:
      change(
          "use `morphe inspect` to check the axes (`axes`, `forward`), the chosen hand, and "
          "whether names of left and right are swapped");
      return relax({"human.max_limit_violation_m=1"},
                   "the reconstructed arm is followed although it exceeds human joint limits");
    case Reason::doubtful_recording:
      for (const RecordingFlag& flag : plan.flags) {
        if (flag.text != plan.detail) continue;
        const std::string accept = fmt::format(
            "correct the recording or, if it is right, accept the flag in its manifest: `accept: "
            "[{}]`",
            name_of(flag.code));
        return change(accept.c_str());
      }
      return;
    case Reason::no_goal:
      return change(
          "at least one fingertip must be seen during the grasp, and the movement must have at "
          "least five frames");
    case Reason::joint_limit:
      return change(
          "correct the joint's limits, or move the base so that the joint stays within them");
    case Reason::duration_too_short:
      return relax({"retime.mode=fastest", "retime.duration_s=null"},
                   "the shortest duration that the limits allow");
    case Reason::smoothing_collision:
      return change("move the base or the obstacles: a path farther from them has been tried");
    case Reason::no_approach:
    case Reason::no_retreat:
      change("choose another home posture (`approach.home`)");
      return relax({"approach=null"},
                   "plans no approach and retreat; the movement itself was planned");
    case Reason::no_reference_frame:
      return change("give the object another `relative_to`, or set `scene.table.height`");
    case Reason::rejected:
      return change("report it, with the recording and the config");
    default:
      return;
  }
}

}  // namespace

std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan) {
  std::vector<Advice> advice;
  const auto solve = [&](std::vector<std::string> settings, std::string sentence) {
    advice.push_back({AdviceKind::may_solve, std::move(settings), std::move(sentence)});
  };
  if (plan.path.position.rows() > 0) {
    const PathViolations violations = find_path_violations(robot, plan);
    const bool goal_collides = plan.reason == Reason::goal_in_collision;
    if (violations.grasp_tip_error || violations.other_tip_error || goal_collides ||
        plan.reason == Reason::start_in_collision)
      solve({"map.base_offset.limit=0.1"}, reach_sentence(plan));
    if (!violations.contacts.empty())
      solve({"repair.attempts=6", "repair.max_iterations=20000"},
            "more attempts and iterations to plan a detour");
    // more effort does not help at an infeasible frame
    if (!violations.empty() && !goal_collides && plan.reason != Reason::unreachable)
      solve({"map.starts=96", "map.candidates=8", "repair.mapping_searches=8"},
            "four times as much search for postures that reach the goals");
    add_relaxed(plan, violations, advice);
  }
  add_for_reason(plan, advice);
  if (advice.empty())
    advice.push_back(
        {AdviceKind::changes_input, {}, "move the base: `morphe place` searches for a position"});
  return advice;
}

std::string text_of(const Advice& advice) {
  constexpr std::array<std::string_view, enum_count<AdviceKind>()> kWords{
      "may solve it", "relax", "change an assumption", ""};
  if (advice.settings.empty()) return advice.sentence;
  std::string settings;
  for (const std::string& setting : advice.settings) {
    const bool spaces = setting.find(' ') != std::string::npos;
    settings += spaces ? fmt::format(" --set '{}'", setting) : " --set " + setting;
  }
  return fmt::format("{}:{}: {}", kWords.at(static_cast<std::size_t>(advice.kind)), settings,
                     advice.sentence);
}

}  // namespace morphe::explain
