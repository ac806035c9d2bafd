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
  return fmt::format("{} is {:.1f} mm from its goal at {:.2f} s{}, {:.1f} allowed", miss.tip,
                     kMillimetresPerMetre * miss.error_m, miss.time_s,
                     miss.grasping ? " in the grasp" : "", kMillimetresPerMetre * miss.allowed_m);
}

std::string violation_text(const ClearanceViolation& contact) {
  const double distance_m = contact.required_m - contact.lacking_clearance_m;
  const std::string asked =
      contact.config_key != "check.margin"
          ? fmt::format("{:.1f} mm of overlap allowed", -kMillimetresPerMetre * contact.required_m)
          : fmt::format("{:.1f} mm apart asked for", kMillimetresPerMetre * contact.required_m);
  return fmt::format("{} and {} {} {:.1f} mm at {:.2f}-{:.2f} s, {}", contact.first, contact.second,
                     distance_m < 0 ? "overlap by" : "come as near as",
                     kMillimetresPerMetre * std::abs(distance_m), contact.begin_s, contact.end_s,
                     asked);
}

/// Sets the margin or the depths that allow all contacts and returns the text; "" if no values do.
std::string relax_contact_tolerances(const PathViolations& shortfall,
                                     std::vector<std::string>& settings) {
  double margin_m = kUnknown;
  std::map<std::string_view, double> depths_m;
  for (const ClearanceViolation& contact : shortfall.contacts) {
    const double distance_m = contact.required_m - contact.lacking_clearance_m;
    if (contact.config_key == "check.margin") {
      margin_m = std::fmin(margin_m, distance_m);
    } else {
      double& depth_m = depths_m.emplace(contact.config_key, 0).first->second;
      depth_m = std::max(depth_m, -distance_m);
    }
  }
  if (margin_m < 1e-4) return "";
  if (!std::isnan(margin_m)) {
    settings.push_back(fmt::format("check.margin={:.4f}", std::floor(1e4 * margin_m - 0.5) / 1e4));
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
  Advice accept{AdviceKind::accepts, {}, ""};
  std::vector<std::string> words;
  double farthest_m = 0;
  const auto allow = [&](const char* key, const std::optional<TipError>& miss) {
    if (!miss) return;
    const double tolerance_m = tolerance_for(miss->error_m);
    farthest_m = std::max(farthest_m, tolerance_m);
    accept.settings.push_back(fmt::format("{}={:.4f}", key, tolerance_m));
    words.push_back(violation_text(*miss));
  };
  allow("check.tracking_grasp", shortfall.grasp_tip_error);
  allow("check.tracking", shortfall.other_tip_error);
  if (!shortfall.contacts.empty()) {
    const std::string contact = relax_contact_tolerances(shortfall, accept.settings);
    if (contact.empty()) {
      advice.push_back({AdviceKind::changes,
                        {},
                        fmt::format("{}: no tolerance allows that; their shapes, the scene or the "
                                    "place of the base would have to change",
                                    violation_text(shortfall.contacts.front()))});
      return;
    }
    words.push_back(contact);
  }
  if (accept.settings.empty()) return;
  accept.sentence = fmt::format("{}", fmt::join(words, "; "));
  if (farthest_m > plan.tolerances.farthest_tip) {
    accept.sentence +=
        fmt::format("; beyond check.farthest_tip, {:.1f} mm, the plan is called approximate",
                    kMillimetresPerMetre * plan.tolerances.farthest_tip);
  }
  advice.push_back(std::move(accept));
}

std::string out_of_reach_words(const Plan& plan) {
  const GoalCount count = count_goals(plan.goals);
  if (count.out_of_reach == 0) return "";
  return fmt::format("{} of {} fingertip goals are out of reach from where the base stands; ",
                     count.out_of_reach, count.all);
}

void add_reach(const Plan& plan, std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::solves,
                    {"map.free_offset.limit=0.1"},
                    out_of_reach_words(plan) +
                        "the base may stand up to 100 mm from there, one place a movement (`morphe "
                        "place` looks for one place for all)"});
}

void add_effort(std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::solves,
                    {"map.starts=96", "map.candidates=8", "repair.searches=8"},
                    "four times the search for other ways to hold the goals"});
}

void add_detours(std::vector<Advice>& advice) {
  advice.push_back({AdviceKind::solves,
                    {"repair.attempts=6", "repair.iterations=20000"},
                    "the planner looks for a way around longer, and more widely"});
}

/// Adds the advice for one reason only.
void add_for_reason(const Plan& plan, std::vector<Advice>& advice) {
  const auto change = [&](const char* sentence) {
    advice.push_back({AdviceKind::changes, {}, sentence});
  };
  switch (plan.reason) {
    case Reason::no_movement:
      change(
          "the recording has to hold a whole reach, from rest to rest: see what `morphe "
          "inspect` finds in it");
      advice.push_back({AdviceKind::accepts,
                        {"segment.whole=true"},
                        "the recording is one movement, whatever happens in it"});
      break;
    case Reason::no_shoulder:
      change(
          "the shoulder has to be seen at least once: markers or sensors of shoulder, elbow and "
          "wrist");
      break;
    case Reason::not_human:
      change(
          "`morphe inspect` says what the body shows: look at the axes (`axes`, `forward`), at the "
          "hand that was taken, and whether names of left and right are swapped");
      advice.push_back({AdviceKind::accepts,
                        {"human.beyond_limits_m=1"},
                        "the arm is followed as it was rebuilt, human or not"});
      break;
    case Reason::no_goal:
      change(
          "at least one fingertip has to be seen while the hand grasps, and five frames of the "
          "movement");
      break;
    case Reason::limit:
      change("limits that the joint can keep, or a place of the base where it has more room");
      break;
    case Reason::duration:
      advice.push_back({AdviceKind::accepts,
                        {"retime.mode=fastest", "retime.duration_s=null"},
                        "as long as the limits make it"});
      break;
    case Reason::smoothing:
    case Reason::collision:
      advice.push_back({AdviceKind::solves,
                        {"map.clearance.band=0.015", "repair.extra_clearance=0.01"},
                        "a path that keeps clear by more leaves room for the smooth curve"});
      break;
    case Reason::no_approach:
    case Reason::no_retreat:
      change("another home posture (`approach.home`)");
      advice.push_back({AdviceKind::accepts,
                        {"approach=null"},
                        "without a way from home and back: the movement itself was planned"});
      break;
    case Reason::no_frame:
      change("another `relative_to` for the object, or a `scene.table.height`");
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
        {AdviceKind::changes, {}, "another place of the base: `morphe place` looks for one"});
  }
  return advice;
}

std::string text_of(const Advice& advice) {
  constexpr std::array<std::string_view, enum_count<AdviceKind>()> kWords{
      "may solve it", "accepts it", "assumes otherwise", ""};
  if (advice.settings.empty()) return advice.sentence;
  std::string settings;
  for (const std::string& one : advice.settings) {
    const bool spaces = one.find(' ') != std::string::npos;
    settings += spaces ? fmt::format(" --set '{}'", one) : " --set " + one;
  }
  return fmt::format("{}:{}: {}", kWords.at(static_cast<std::size_t>(advice.effect)), settings,
                     advice.sentence);
}

}  // namespace morphe::explain
