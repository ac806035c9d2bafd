#include "pipeline/report/worst_instant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::report {
namespace {

bool is_about_contact(Reason reason) {
  return reason == Reason::start_in_collision || reason == Reason::goal_in_collision ||
         reason == Reason::no_path || reason == Reason::smoothing_collision;
}

bool is_about_tips(Reason reason) {
  return reason == Reason::tracking || reason == Reason::unreachable;
}

struct ClearanceViolation {
  double demonstration_s = kUnknown;
  collision::PairSeparation pair;
};

/// Finds the row with the least slack, empty if no pair is closer than allowed.
std::optional<ClearanceViolation> worst_contact(const std::vector<DisplayMotion>& motions) {
  std::optional<ClearanceViolation> worst;
  for (const DisplayMotion& motion : motions) {
    for (std::size_t k = 0; k < motion.nearest.size(); ++k) {
      const collision::PairSeparation& pair = motion.nearest[k];
      if (pair.capsule < 0 || !(pair.slack() < 0)) continue;
      if (!worst || pair.slack() < worst->pair.slack())
        worst = ClearanceViolation{motion.demonstration_time[k], pair};
    }
  }
  return worst;
}

struct TipError {
  double demonstration_s = kUnknown, error = 0, tolerance = 0;
  std::size_t tip = 0;
  bool grasping = false;
  double excess() const { return error - tolerance; }
};

/// Finds the tip with the largest excess over the tolerance of its phase, empty if all are within
/// it.
std::optional<TipError> worst_miss(const Plan& plan, const std::vector<DisplayMotion>& motions) {
  std::optional<TipError> worst;
  for (const DisplayMotion& motion : motions) {
    for (Eigen::Index row = 0; row < motion.tip_error.rows(); ++row) {
      const double time_s = motion.demonstration_time[row];
      const bool grasping = is_grasping_at(plan.movement, time_s);
      const Tolerances& allowed = plan.tolerances;
      const double tolerance =
          grasping ? allowed.tracking_tolerance_grasp : allowed.tracking_tolerance;
      for (Eigen::Index tip = 0; tip < motion.tip_error.cols(); ++tip) {
        const TipError miss{time_s, motion.tip_error(row, tip), tolerance,
                            static_cast<std::size_t>(tip), grasping};
        if (miss.excess() > (worst ? worst->excess() : 0)) worst = miss;
      }
    }
  }
  return worst;
}

const Finding* deepest_finding(const Plan& plan) {
  const auto deepest = std::ranges::max_element(plan.findings, {}, &Finding::excess);
  return deepest == plan.findings.end() ? nullptr : &*deepest;
}

std::string other_name(const robot::Robot& robot, const Plan& plan,
                       const collision::PairSeparation& pair) {
  const auto i = static_cast<std::size_t>(pair.other);
  return pair.other_is_object ? plan.scene.objects[i].name : robot.capsules[i].name;
}

std::string distance_words(double distance) {
  return distance < 0 ? fmt::format("overlap by {:.2f} mm", -kMillimetresPerMetre * distance)
                      : fmt::format("are {:.2f} mm apart", kMillimetresPerMetre * distance);
}

std::string required_words(double required) {
  return required < 0
             ? fmt::format("{:.2f} mm of overlap is allowed", -kMillimetresPerMetre * required)
             : fmt::format("the minimum is {:.2f} mm", kMillimetresPerMetre * required);
}

std::string contact_sentence(const robot::Robot& robot, const Plan& plan,
                             const collision::PairSeparation& pair) {
  return fmt::format("{} and {} {}; {}", robot.capsules[pair.capsule].name,
                     other_name(robot, plan, pair), distance_words(pair.separation.distance),
                     required_words(pair.required_distance_m));
}

std::string miss_sentence(const robot::Robot& robot, const TipError& miss) {
  return fmt::format("{} is {:.2f} mm from its goal; the tolerance is {:.2f} mm {}",
                     robot.tips[miss.tip].name, kMillimetresPerMetre * miss.error,
                     kMillimetresPerMetre * miss.tolerance,
                     miss.grasping ? "in grasp and hold" : "outside grasp and hold");
}

std::string finding_sentence(const Finding& finding) {
  return fmt::format(
      "{}: {}{}{}, {:.4f} {} beyond the limit", name_of(finding.cause), finding.subject,
      finding.other_body.empty() ? "" : " and ", finding.other_body, finding.excess,
      finding.cause == Cause::jump || finding.cause == Cause::joint_limit ? "rad" : "m");
}

}  // namespace

std::optional<WorstInstant> worst_instant(const robot::Robot& robot, const Plan& plan,
                                          const std::vector<DisplayMotion>& motions) {
  if (is_about_contact(plan.reason)) {
    if (const auto contact = worst_contact(motions))
      return WorstInstant{contact->demonstration_s, contact_sentence(robot, plan, contact->pair)};
  }
  if (is_about_tips(plan.reason)) {
    if (const auto miss = worst_miss(plan, motions))
      return WorstInstant{miss->demonstration_s, miss_sentence(robot, *miss)};
  }
  if (const Finding* finding = deepest_finding(plan))
    return WorstInstant{0.5 * (finding->begin_s + finding->end_s), finding_sentence(*finding)};
  return std::nullopt;
}

}  // namespace morphe::report
