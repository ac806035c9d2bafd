#include "stages/export/export_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/assumption_text.hpp"
#include "core/motion/count_with_noun.hpp"

namespace morphe::exports {
namespace {

/// Returns true if all times fit the 32-bit seconds of ROS messages.
bool fits_ros_duration(const std::vector<PlanMotion>& motions) {
  constexpr double kMaxRosTime_s = 2147483647;
  return std::ranges::all_of(motions, [&](const PlanMotion& motion) {
    return std::ranges::all_of(motion.trajectory.time,
                               [&](double t) { return std::abs(t) <= kMaxRosTime_s; });
  });
}

/// Makes the velocity at the end of every motion exactly zero, as joint_trajectory_controller
/// requires. Returns the reason for which it cannot: the motion does not end at rest.
std::string stop_at_end(const RobotModel& robot, std::vector<PlanMotion>& motions) {
  constexpr double kMaxEndVelocity = 1e-6;  // [rad/s or m/s] rounding of resampled motions
  for (PlanMotion& motion : motions) {
    auto last = motion.trajectory.velocity.bottomRows<1>();
    Eigen::Index joint = 0;
    const double speed = last.cwiseAbs().maxCoeff(&joint);
    if (speed > kMaxEndVelocity)
      return fmt::format("{}: does not end at rest, which a controller refuses: {} moves at {:.2g}",
                         motion.name, robot.joint_names[joint], speed);
    last.setZero();
  }
  return "";
}

/// Returns the phases of a motion as segments of its points.
std::vector<IndexedPhase> phases_of(const Trajectory& t) {
  std::vector<IndexedPhase> phases;
  for (std::size_t i = 0; i < t.samples(); ++i) {
    if (phases.empty() || phases.back().kind != t.phase[i])
      phases.push_back({t.phase[i], i, i, t.time[i], t.time[i]});
    // A segment ends where the next one begins, the last one with the motion.
    phases.back().last_point = i;
    phases.back().end_s = t.time[std::min(i + 1, t.samples() - 1)];
  }
  return phases;
}

}  // namespace

double sample_rate_hz(const Trajectory& t) {
  return std::round(1e6 * static_cast<double>(t.samples() - 1) / (t.time.back() - t.time[0])) / 1e6;
}

std::vector<PlanMotion> add_to_index(ExportRun& run, const ChosenPlan& chosen, const Plan& plan) {
  const MotionOptions& options = run.options.motion;
  auto [motions, reason] = motions_of(run.reader.robot(), plan, options);
  if (reason.empty() && run.options.format.starts_with("ros")) {
    reason = stop_at_end(run.reader.robot(), motions);
    if (!fits_ros_duration(motions)) reason = "is longer than a ROS message can express (2^31 s)";
  }
  const std::string& path = run.reader.plan_paths()[chosen.index];
  if (!reason.empty()) {
    run.index.skipped.push_back({path, reason});
    return {};
  }
  if (run.index.plans.empty())
    run.index.rate_hz =
        options.rate_hz > 0 ? options.rate_hz : options.parts * sample_rate_hz(plan.trajectory);
  run.has_approach_or_retreat =
      run.has_approach_or_retreat || plan.approach.samples() > 0 || plan.retreat.samples() > 0;
  IndexedPlan& indexed = run.index.plans.emplace_back();
  indexed.plan = path;
  indexed.status = plan.status();
  indexed.subject = plan.subject;
  indexed.flags = plan.flags;
  indexed.assumptions = plan_assumptions(plan);
  indexed.task = plan.task;
  indexed.side = chosen.side;
  for (const auto& [name, t] : motions) {
    IndexedMotion& entry = indexed.motions.emplace_back();
    entry.name = name;
    entry.duration_s = t.time.back() - t.time[0];
    entry.points = t.samples();
    entry.phases = phases_of(t);
    if (!run.index.has_limits) continue;
    entry.limits = limit_use(run.reader.robot(), t);
    run.limits.add(entry.limits, indexed.plan);
  }
  return std::move(motions);
}

double time_before_s(const Plan& plan, const MotionOptions& options) {
  const bool joined = options.approach == ApproachMode::joined && plan.approach.samples() > 0;
  return options.delay_s + (joined ? plan.approach.time.back() - plan.approach.time[0] : 0);
}

double grasp_time_s(const Plan& plan, const MotionOptions& options) {
  const Trajectory& t = plan.trajectory;
  return time_before_s(plan, options) + t.time[plan.grasp.sample] - t.time[0];
}

std::string card_of(const ExportRun& run, const std::string& kind, const std::string& front_matter,
                    const std::string& content) {
  const RobotModel& robot = run.reader.robot();
  const CardOptions options{
      fmt::format("{}: {} of {}", kind, count_with_noun(run.selection.counts.chosen, "plan"),
                  robot.name),
      front_matter,
      content,
      run.options.where,
      run.options.split,
      run.options.not_verified};
  return dataset_card(run.selection.counts, options, run.reader.header(), robot);
}

}  // namespace morphe::exports
