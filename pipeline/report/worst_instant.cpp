#include "pipeline/report/worst_instant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/finding_text.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::report {
namespace {

struct ClearanceViolation {
  double demonstration_s = kUnknown;
  collision::PairSeparation pair;
};

/// Returns the pair with the least slack of all rows; nullopt if no pair is closer than allowed.
std::optional<ClearanceViolation> worst_contact(const std::vector<DisplayMotion>& motions) {
  std::optional<ClearanceViolation> worst;
  for (const DisplayMotion& motion : motions) {
    for (int k = 0; k < std::ssize(motion.nearest); ++k) {
      const collision::PairSeparation& pair = motion.nearest[k];
      if (pair.first < 0 || !(pair.slack() < 0)) continue;
      if (!worst || pair.slack() < worst->pair.slack())
        worst = ClearanceViolation{motion.demonstration_time[k], pair};
    }
  }
  return worst;
}

struct TipError {
  double demonstration_s = kUnknown, error = 0, tolerance = 0;
  Eigen::Index tip = 0;
  bool grasping = false;
  double excess() const { return error - tolerance; }
};

/// Returns the largest excess of a tip error over the tolerance of its phase; nullopt without one.
std::optional<TipError> worst_tip_error(const Plan& plan,
                                        const std::vector<DisplayMotion>& motions) {
  std::optional<TipError> worst;
  for (const DisplayMotion& motion : motions) {
    for (Eigen::Index row = 0; row < motion.tip_error.rows(); ++row) {
      const double time_s = motion.demonstration_time[row];
      const bool grasping = is_grasping_at(plan.movement, time_s);
      const Tolerances& allowed = plan.tolerances;
      const double tolerance =
          grasping ? allowed.tracking_tolerance_grasp : allowed.tracking_tolerance;
      for (Eigen::Index tip = 0; tip < motion.tip_error.cols(); ++tip) {
        const TipError error{time_s, motion.tip_error(row, tip), tolerance, tip, grasping};
        if (error.excess() > (worst ? worst->excess() : 0)) worst = error;
      }
    }
  }
  return worst;
}

std::string contact_sentence(const robot::Robot& robot, const Plan& plan,
                             const collision::PairSeparation& pair) {
  const auto name_of_body = [&](bool is_object, int body) -> const std::string& {
    return is_object ? plan.scene.objects[body].name : robot.capsules[body].name;
  };
  const double distance_mm = kMillimetresPerMetre * pair.separation.distance,
               required_mm = kMillimetresPerMetre * pair.required_distance_m;
  return fmt::format("{} and {} {}; {}", name_of_body(pair.first_is_object, pair.first),
                     name_of_body(pair.other_is_object, pair.other),
                     distance_mm < 0 ? fmt::format("overlap by {:.2f} mm", -distance_mm)
                                     : fmt::format("are {:.2f} mm apart", distance_mm),
                     required_mm < 0 ? fmt::format("{:.2f} mm of overlap is allowed", -required_mm)
                                     : fmt::format("the minimum is {:.2f} mm", required_mm));
}

std::string tip_sentence(const robot::Robot& robot, const TipError& error) {
  return fmt::format("{} is {:.2f} mm from its goal; the tolerance is {:.2f} mm {}",
                     robot.tips[error.tip].name, kMillimetresPerMetre * error.error,
                     kMillimetresPerMetre * error.tolerance,
                     error.grasping ? "in grasp and hold" : "outside grasp and hold");
}

}  // namespace

std::optional<WorstInstant> worst_instant(const robot::Robot& robot, const Plan& plan,
                                          const std::vector<DisplayMotion>& motions) {
  const Reason reason = plan.reason;
  if (reason == Reason::start_in_collision || reason == Reason::goal_in_collision ||
      reason == Reason::no_path || reason == Reason::smoothing_collision) {
    if (const auto contact = worst_contact(motions))
      return WorstInstant{contact->demonstration_s, contact_sentence(robot, plan, contact->pair)};
  }
  if (reason == Reason::tracking || reason == Reason::unreachable) {
    if (const auto error = worst_tip_error(plan, motions))
      return WorstInstant{error->demonstration_s, tip_sentence(robot, *error)};
  }
  const auto finding = std::ranges::max_element(plan.findings, {}, &Finding::excess_m);
  if (finding == plan.findings.end()) return std::nullopt;
  return WorstInstant{0.5 * (finding->begin_s + finding->end_s), sentence(*finding)};
}

}  // namespace morphe::report
