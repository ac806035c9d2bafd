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

constexpr double kSmoothingAllowance_m = 3e-4;  ///< tolerance consumed by smoothing and certificate
/// allowance because repair may end with another path under another tolerance
constexpr double kReplanAllowanceShare = 0.05;

/// Returns the tolerance for an error, rounded up to half a millimetre.
double tolerance_for(double error_m) {
  return std::ceil(2e3 * ((1 + kReplanAllowanceShare) * error_m + kSmoothingAllowance_m)) / 2e3;
}

std::string violation_text(const TipError& miss) {
  return fmt::format("{} is {:.1f} mm from its goal at {:.2f} s{} (allowed: {:.1f} mm)", miss.tip,
                     kMillimetresPerMetre * miss.error_m, miss.time_s,
                     miss.grasping ? " in the grasp" : "", kMillimetresPerMetre * miss.allowed_m);
}

std::string violation_text(const ClearanceViolation& contact) {
  const double distance_m = contact.required_m - contact.lacking_clearance_m;
  const std::string asked =
      contact.config_key != "check.required_clearance"
          ? fmt::format("allowed: {:.1f} mm", -kMillimetresPerMetre * contact.required_m)
          : fmt::format("required distance: {:.1f} mm", kMillimetresPerMetre * contact.required_m);
  const double distance_mm = kMillimetresPerMetre * std::abs(distance_m);
  const std::string distance = distance_m < 0 ? fmt::format("overlap by {:.1f} mm", distance_mm)
                                              : fmt::format("are {:.1f} mm apart", distance_mm);
  return fmt::format("{} and {} {}, {:.2f}–{:.2f} s ({})", contact.first, contact.second, distance,
                     contact.begin_s, contact.end_s, asked);
}

/// Sets the margin or the depths that allow all contacts and returns the text; "" if no values do.
std::string relax_contact_tolerances(const PathViolations& shortfall,
                                     std::vector<std::string>& settings) {
  double margin_m = kUnknown;
  std::map<std::string_view, double> depths_m;
  for (const ClearanceViolation& contact : shortfall.contacts) {
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
  for (const auto& [key, depth_m] : depths_m) {
    settings.push_back(fmt::format("{}={:.4f}", key, tolerance_for(depth_m)));
  }
  return violation_text(shortfall.contacts.front());
}

/// Adds the advice whose tolerances accept the path as it is, if there is any.
void add_acceptance(const Plan& plan, const PathViolations& shortfall,
                    std::vector<Advice>& advice) {
  if (!shortfall.jumps.empty() || !shortfall.limits.empty()) return;
  Advice accept{AdviceKind::relaxes_tolerance, {}, ""};
  std::vector<std::string> words;
  double farthest_m = 0;
  const auto allow = [&](const char* key, const std::optional<TipError>& miss) {
    if (!miss) return;
    const double tolerance_m = tolerance_for(miss->error_m);
    farthest_m = std::max(farthest_m, tolerance_m);
    accept.settings.push_back(fmt::format("{}={:.4f}", key, tolerance_m));
    words.push_back(violation_text(*miss));
  };
  allow("check.tracking_tolerance_grasp", shortfall.grasp_tip_error);
  allow("check.tracking_tolerance", shortfall.other_tip_error);
  if (!shortfall.contacts.empty()) {
    const std::string contact = relax_contact_tolerances(shortfall, accept.settings);
    if (contact.empty()) {
      advice.push_back({AdviceKind::changes_input,
                        {},
                        fmt::format("{}: no tolerance can allow this; change their shapes, the "
                                    "scene or the position of the base",
                                    violation_text(shortfall.contacts.front()))});
      return;
    }
    words.push_back(contact);
  }
  if (accept.settings.empty()) return;
  accept.sentence = fmt::format("{}; the error stays", fmt::join(words, "; "));
  if (farthest_m > plan.tolerances.max_tip_error) {
    accept.sentence +=
        fmt::format("; errors above check.max_tip_error ({:.1f} mm) give the status approximate",
                    kMillimetresPerMetre * plan.tolerances.max_tip_error);
  }
  advice.push_back(std::move(accept));
}

std::string out_of_reach_words(const Plan& plan) {
  const GoalCount count = count_goals(plan.goals);
  if (count.out_of_reach == 0) return "";
  return fmt::format("{} of {} fingertip goals are out of reach from this base position; ",
                     count.out_of_reach, count.all);
}

void add_reach(const Plan& plan, std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::may_solve,
                    {"map.base_offset.limit=0.1"},
                    out_of_reach_words(plan) +
                        "the base may move by up to 100 mm, separately for each movement "
                        "(`morphe place` searches for one position for all)"});
}

void add_effort(std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::may_solve,
                    {"map.starts=96", "map.candidates=8", "repair.mapping_searches=8"},
                    "four times as much search for postures that reach the goals"});
}

void add_detours(std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::may_solve,
                    {"repair.attempts=6", "repair.max_iterations=20000"},
                    "more attempts and iterations to plan a detour"});
}

/// Adds the advice for one reason only.
void add_for_reason(const Plan& plan, std::vector<Advice>& advice) {
  const auto change = [&](const char* sentence) {
    advice.push_back({AdviceKind::changes_input, {}, sentence});
  };
  switch (plan.reason) {
    case Reason::no_movement:
      change(
          "the recording must contain a complete reach, from rest to rest; `morphe inspect` shows "
          "what was found in it");
      advice.push_back({AdviceKind::relaxes_tolerance,
                        {"segment.whole_recording=true"},
                        "the whole recording becomes one movement"});
      break;
    case Reason::no_shoulder:
      change(
          "the shoulder must be seen at least once: record markers or sensors of shoulder, elbow "
          "and wrist");
      break;
    case Reason::implausible_arm:
      change(
          "use `morphe inspect` to check the axes (`axes`, `forward`), the chosen hand, and "
          "whether names of left and right are swapped");
      advice.push_back(
          {AdviceKind::relaxes_tolerance,
           {"human.max_limit_violation_m=1"},
           "the reconstructed arm is followed although it exceeds human joint limits"});
      break;
    case Reason::no_goal:
      change(
          "at least one fingertip must be seen during the grasp, and the movement must have at "
          "least five frames");
      break;
    case Reason::joint_limit:
      change("correct the joint's limits, or move the base so that the joint stays within them");
      break;
    case Reason::duration_too_short:
      advice.push_back({AdviceKind::relaxes_tolerance,
                        {"retime.mode=fastest", "retime.duration_s=null"},
                        "the shortest duration that the limits allow"});
      break;
    case Reason::smoothing_collision:
      advice.push_back({AdviceKind::may_solve,
                        {"map.clearance.activation_distance=0.015", "repair.extra_clearance=0.01"},
                        "a path farther from the obstacles leaves room for smoothing"});
      break;
    case Reason::no_approach:
    case Reason::no_retreat:
      change("choose another home posture (`approach.home`)");
      advice.push_back({AdviceKind::relaxes_tolerance,
                        {"approach=null"},
                        "plans no approach and retreat; the movement itself was planned"});
      break;
    case Reason::no_reference_frame:
      change("give the object another `relative_to`, or set `scene.table.height`");
      break;
    default:
      break;
  }
}

bool is_about_tips(const PathViolations& shortfall) {
  return shortfall.grasp_tip_error || shortfall.other_tip_error;
}

}  // namespace

std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan) {
  std::vector<Advice> advice;
  if (plan.path.position.rows() > 0) {
    const PathViolations shortfall = find_path_violations(robot, plan);
    if (is_about_tips(shortfall) || plan.reason == Reason::goal_in_collision ||
        plan.reason == Reason::start_in_collision) {
      add_reach(plan, advice);
    }
    if (!shortfall.contacts.empty()) add_detours(advice);
    const bool dead_end =
        plan.reason == Reason::unreachable || plan.reason == Reason::goal_in_collision;
    // more effort does not help at an infeasible frame
    if (!shortfall.empty() && !dead_end) add_effort(advice);
    add_acceptance(plan, shortfall, advice);
  }
  add_for_reason(plan, advice);
  if (advice.empty()) {
    advice.push_back(
        {AdviceKind::changes_input, {}, "move the base: `morphe place` searches for a position"});
  }
  return advice;
}

std::string text_of(const Advice& advice) {
  constexpr std::array<std::string_view, enum_count<AdviceKind>()> kWords{
      "may solve it", "relax", "change an assumption", ""};
  if (advice.settings.empty()) return advice.sentence;
  std::string settings;
  for (const std::string& one : advice.settings) {
    const bool spaces = one.find(' ') != std::string::npos;
    settings += spaces ? fmt::format(" --set '{}'", one) : " --set " + one;
  }
  return fmt::format("{}:{}: {}", kWords.at(static_cast<std::size_t>(advice.kind)), settings,
                     advice.sentence);
}

}  // namespace morphe::explain
