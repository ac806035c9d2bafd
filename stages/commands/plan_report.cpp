#include "stages/commands/plan_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stages/place/reach.hpp"
#include "stages/planning/palm_error.hpp"

namespace morphe::commands {
namespace {

/// "-" for what was not measured.
std::string number(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

struct Tracking {
  std::size_t goals = 0, unreachable = 0;
  double worst_m = kNotSeen;  ///< of the mapped frames, over reachable goals
};

Tracking tracking_of(const Plan& plan) {
  Tracking tracking;
  const JointRows& errors = plan.mapped.position_error;
  for (Eigen::Index f = 0; f < errors.rows(); ++f) {
    for (Eigen::Index tip = 0; tip < errors.cols(); ++tip) {
      if (std::isnan(errors(f, tip))) continue;
      ++tracking.goals;
      if (plan.goals.reachable(static_cast<std::size_t>(f), static_cast<std::size_t>(tip))) {
        tracking.worst_m = std::fmax(tracking.worst_m, errors(f, tip));
      } else {
        ++tracking.unreachable;
      }
    }
  }
  return tracking;
}

double mean_mm(const JointRows& errors) {
  double sum = 0;
  int count = 0;
  for (const double error : errors.reshaped()) {
    if (std::isnan(error)) continue;
    sum += error;
    ++count;
  }
  return count > 0 ? 1e3 * sum / count : kNotSeen;
}

/// Where goals are out of reach: how far the tips are from them, and how far they have to be.
std::string reach_row(const Plan& plan) {
  const JointRows& nearest = plan.mapped.nearest_error;
  const JointRows there = nearest.array().isNaN().select(kNotSeen, plan.mapped.position_error);
  if (std::isnan(mean_mm(nearest))) return "";
  return fmt::format(
      "\n  out of reach: tips {} mm from these goals in the mean, {} as near as they can come; {} "
      "mm over all goals",
      number(mean_mm(there), 1), number(mean_mm(nearest), 1),
      number(mean_mm(plan.mapped.position_error), 1));
}

/// Largest step of a joint between two frames of the mapping, per 10 ms [rad].
double largest_step(const Plan& plan) {
  double largest = 0;
  const JointRows& q = plan.mapped.position;
  for (Eigen::Index f = 1; f < q.rows(); ++f) {
    const auto i = static_cast<std::size_t>(f);
    const double step_s = plan.goals.time[i] - plan.goals.time[i - 1];
    largest = std::max(largest, (q.row(f) - q.row(f - 1)).cwiseAbs().maxCoeff() * 0.01 / step_s);
  }
  return largest;
}

}  // namespace

std::string plan_table_head() {
  return fmt::format(
      "{:<22} {:<11} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}\n"
      "{:<22} {:<11} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}",
      "plan", "status", "mapped", "out of", "largest", "tips at", "tips", "upper arm", "palm",
      "clearance", "tempo", "", "", "tips mm", "reach %", "step rad", "grasp mm", "max mm",
      "mean deg", "mean deg", "mm", "");
}

std::string plan_rows(const RobotTable& robot, const Plan& plan) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const Certificate& c = plan.certificate;
  const Tracking tracking = tracking_of(plan);
  const std::string name = fmt::format("{}/{:03}", plan.demonstration, plan.movement.index);
  std::string rows = fmt::format(
      "{:<22} {:<11} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8}", name,
      plan.executable() ? (c.repaired ? "repaired" : "executable") : "infeasible",
      number(1e3 * tracking.worst_m, 2),
      number(tracking.goals ? 100.0 * static_cast<double>(tracking.unreachable) /
                                  static_cast<double>(tracking.goals)
                            : kNotSeen,
             1),
      number(largest_step(plan), 3), number(1e3 * c.position_error_grasp, 2),
      number(1e3 * c.position_error_max, 2), number(kDegrees * c.upper_arm_error_mean, 1),
      number(kDegrees * planning::palm_error(robot, plan), 1), number(1e3 * c.clearance, 1),
      number(c.tempo, 2));
  if (!plan.executable()) {
    const bool said = plan.detail.starts_with(fmt::format("{}:", name_of(plan.reason)));
    rows +=
        said ? "\n  " + plan.detail : fmt::format("\n  {}: {}", name_of(plan.reason), plan.detail);
  }
  if (plan.executable() && !plan.detail.empty()) rows += "\n  note: " + plan.detail;
  rows += reach_row(plan);
  for (const Finding& finding : plan.findings) {
    rows +=
        fmt::format("\n  found: {} {}{} at {:.2f}-{:.2f} s, {:.4f} too far", name_of(finding.cause),
                    finding.first, finding.second.empty() ? "" : " " + finding.second,
                    finding.begin_s, finding.end_s, finding.depth);
  }
  return rows;
}

std::string base_sentence(const RobotTable& robot, const map::PlacementOptions& placement,
                          const Plan& plan) {
  if (map::hand_alone(robot)) return "";
  const place::Stand stand = place::stand_of(placement);
  const Vec3 base = 1e3 * place::base_from_human_shoulder(stand, map::robot_shoulder(robot));
  const Vec3 up = stand.up();
  std::string text = fmt::format(
      "{}: base ({:.0f}, {:.0f}, {:.0f}) mm right of, before and above the person's shoulder, z "
      "axis ({:.2f}, {:.2f}, {:.2f})",
      robot.name, base.x(), base.y(), base.z(), up.x(), up.y(), up.z());
  if (const SceneObject* table = object_named(plan.scene.objects, "table")) {
    const Vec3 from_middle = recorded_pose(*table, 0).inverse() * Vec3::Zero();
    const double above = 1e3 * (from_middle.z() - table->size[2] / 2);
    text += fmt::format(", {:.0f} mm above the table", above);
  }
  return text;
}

std::string plan_table_foot(const RobotTable& robot, const run::BatchSummary& summary) {
  std::string text = fmt::format("{}: {} of {} fingertip goals out of reach from this placement",
                                 robot.name, summary.out_of_reach, summary.goals);
  const std::string unchecked = unchecked_sentence(robot.unchecked_links);
  if (!unchecked.empty()) text += fmt::format("\n{}: {}", robot.name, unchecked);
  return text;
}

}  // namespace morphe::commands
