#include "pipeline/explain/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "core/config/fields.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/explain/path_violations.hpp"
#include "pipeline/explain/reasons.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::explain {
namespace {

constexpr double kSmoothingAllowance_m = 3e-4;  ///< error added by smoothing and certificate
constexpr double kReplanAllowanceShare = 0.05;  ///< of the error, because a new plan differs
constexpr double kAdvisedBaseOffset_m = 0.1;    ///< chosen by hand: about a palm's breadth
/// Factors on the effort of the run, chosen by hand so that a plan takes minutes, not hours.
constexpr int kMoreAttempts = 2, kMoreIterations = 7;
constexpr int kMoreStarts = 4, kMoreCandidates = 2, kMoreSearches = 3;
constexpr double kCurveToleranceFactor = 1.5;  ///< chosen by hand: smoothing adds less

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

std::string reach_sentence(const Plan& plan, const AdviceContext& context) {
  const GoalCount count = count_goals(plan.goals);
  const std::string goals =
      count.out_of_reach == 0
          ? ""
          : fmt::format("{} of {} fingertip goals are out of reach from this base position; ",
                        count.out_of_reach, count.all);
  return goals + "the base may move by up to 100 mm, separately for each movement" +
         (context.placed_by_search ? "" : " (`morphe place` searches for one position for all)");
}

/// Adds the advice to search with more effort than the config does.
void add_search(const Plan& plan, const PathViolations& violations, const AdviceContext& context,
                std::vector<Advice>& advice) {
  const auto solve = [&](std::vector<std::string> settings, std::string sentence) {
    advice.push_back({AdviceKind::may_solve, std::move(settings), std::move(sentence)});
  };
  const Dependence& depends_on = explanation_of(plan.reason).depends_on;
  const bool misses_goals = violations.grasp_tip_error || violations.other_tip_error;
  const bool collides_at_end =
      plan.reason == Reason::goal_in_collision || plan.reason == Reason::start_in_collision;
  if (depends_on.base && (misses_goals || collides_at_end) &&
      context.base_offset_limit_m < kAdvisedBaseOffset_m)
    solve({fmt::format("map.base_offset.limit={}", kAdvisedBaseOffset_m)},
          reach_sentence(plan, context));
  if (!depends_on.search) return;  // more effort does not help at an infeasible frame
  if (depends_on.distance && !violations.contacts.empty())
    solve({fmt::format("repair.attempts={}", kMoreAttempts * context.repair_attempts),
           fmt::format("repair.max_iterations={}", kMoreIterations * context.repair_iterations)},
          "more attempts and iterations to plan a detour");
  if (!violations.empty())
    solve({fmt::format("map.starts={}", kMoreStarts * context.map_starts),
           fmt::format("map.candidates={}", kMoreCandidates * context.map_candidates),
           fmt::format("repair.mapping_searches={}", kMoreSearches * context.mapping_searches)},
          "four times as much search for postures that reach the goals");
}

/// Adds larger tolerances for a plan whose path keeps them, but not the curve through it.
void add_curve_tolerance(const Plan& plan, const PathViolations& violations,
                         std::vector<Advice>& advice) {
  if (plan.reason != Reason::tracking || !violations.empty()) return;
  const Tolerances& now = plan.tolerances;
  advice.push_back(
      {AdviceKind::relaxes_tolerance,
       {fmt::format("check.tracking_tolerance_grasp={:.4f}",
                    kCurveToleranceFactor * now.tracking_tolerance_grasp),
        fmt::format("check.tracking_tolerance={:.4f}",
                    kCurveToleranceFactor * now.tracking_tolerance)},
       "the path keeps the tolerances, the curve that can be executed does not; half as much again "
       "is allowed"});
}

/// Adds the advice of the reason itself.
void add_for_reason(const Plan& plan, std::vector<Advice>& advice) {
  for (const RecordingFlag& flag : plan.flags) {
    if (plan.reason != Reason::doubtful_recording || flag.text != plan.detail) continue;
    advice.push_back({AdviceKind::changes_input,
                      {},
                      fmt::format("correct the recording or, if it is right, accept the flag in "
                                  "its manifest: `accept: [{}]`",
                                  name_of(flag.code))});
    return;
  }
  for (const FixedAdvice& fixed : explanation_of(plan.reason).advice) {
    if (fixed.sentence.empty()) continue;
    Advice& one = advice.emplace_back(Advice{fixed.kind, {}, std::string(fixed.sentence)});
    for (const std::string_view setting : fixed.settings)
      if (!setting.empty()) one.settings.emplace_back(setting);
  }
}

/// Returns the advice for a plan whose numbers give none.
Advice general_advice(const AdviceContext& context) {
  return {AdviceKind::changes_input,
          {},
          context.placed_by_search
              ? "use a robot with a longer reach or a thinner hand, or change the scene: the base "
                "stands at the best position that a search found"
              : "move the base: `morphe place` searches for a position"};
}

}  // namespace

AdviceContext advice_context(const planning::PipelineConfig& config) {
  return {config.placement.found_by.has_value(),
          config.map.base_offset.limit_m,
          config.map.starts,
          config.map.candidates,
          config.repair.mapping_searches,
          config.repair.attempts,
          config.repair.max_iterations};
}

AdviceContext advice_context(const std::string& stored_config) {
  try {
    planning::PipelineConfig config;
    config::read_options(config::ConfigNode::parse(stored_config, "@config"), config);
    return advice_context(config);
  } catch (const InputError&) {
    return {};
  }
}

std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan,
                               const AdviceContext& context) {
  std::vector<Advice> advice;
  if (plan.path.position.rows() > 0) {
    const PathViolations violations = find_path_violations(robot, plan);
    add_search(plan, violations, context, advice);
    add_relaxed(plan, violations, advice);
    add_curve_tolerance(plan, violations, advice);
  }
  add_for_reason(plan, advice);
  if (advice.empty()) advice.push_back(general_advice(context));
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
