#include "pipeline/commands/plan_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/math/statistics.hpp"

namespace morphe::commands {
namespace {

/// Calls visit(error [m], in reach) for each fingertip goal of the mapped frames.
template <class Visit>
void visit_goals(const Plan& plan, const Visit& visit) {
  const JointRows& errors = plan.mapped.tip_error;
  for (Eigen::Index f = 0; f < errors.rows(); ++f)
    for (Eigen::Index tip = 0; tip < errors.cols(); ++tip)
      if (!std::isnan(errors(f, tip))) visit(errors(f, tip), plan.goals.reachable(f, tip) != 0);
}

/// Returns the largest error over the goals in reach [m].
double mapped_tip_error_max(const RobotModel&, const Plan& plan) {
  double worst_m = kUnknown;
  visit_goals(plan, [&](double error_m, bool reachable) {
    if (reachable) worst_m = std::fmax(worst_m, error_m);
  });
  return worst_m;
}

double share_out_of_reach(const RobotModel&, const Plan& plan) {
  double goals = 0, out = 0;
  visit_goals(plan, [&](double, bool reachable) {
    goals += 1;
    out += reachable ? 0 : 1;
  });
  return goals > 0 ? out / goals : kUnknown;
}

/// Returns the largest step of a joint between two frames of the mapping, per 10 ms [rad].
double largest_step(const RobotModel&, const Plan& plan) {
  double largest = 0;
  const JointRows& q = plan.mapped.position;
  for (Eigen::Index f = 1; f < q.rows(); ++f) {
    const double step_s = plan.goals.time[f] - plan.goals.time[f - 1];
    largest = std::max(largest, (q.row(f) - q.row(f - 1)).cwiseAbs().maxCoeff() * 0.01 / step_s);
  }
  return largest;
}

double duration(const RobotModel&, const Plan& plan) {
  return plan.trajectory.time.empty() ? kUnknown : plan.trajectory.time.back();
}

template <double Certificate::*figure>
double certificate_figure(const RobotModel&, const Plan& plan) {
  return plan.certificate.*figure;
}

constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

constexpr std::array<PlanFigure, kPlanFigureCount> kFigures{{
    {"mapped_tip_error", "mapped tips", "mm", 1e3, 2, 1, mapped_tip_error_max},
    {"unreachable_share", "out of reach", "%", 100, 1, 1, share_out_of_reach},
    {"max_joint_step", "mapped joint step", "rad", 1, 3, 1, largest_step},
    {"tip_error_grasp", "tips at grasp", "mm", 1e3, 2, 1,
     certificate_figure<&Certificate::tip_error_grasp>},
    {"tip_error_mean", "tips mean", "mm", 1e3, 2, 1,
     certificate_figure<&Certificate::tip_error_mean>},
    {"tip_error_max", "tips max", "mm", 1e3, 2, 1, certificate_figure<&Certificate::tip_error_max>},
    {"humanlikeness", "humanlikeness A", "cm^2", 1e4, 1, 1,
     certificate_figure<&Certificate::humanlikeness_final>, true},
    {"upper_arm_error", "upper arm", "deg", kDegreesPerRadian, 1, 1,
     certificate_figure<&Certificate::upper_arm_error_mean>, true},
    {"forearm_error", "forearm", "deg", kDegreesPerRadian, 1, 1,
     certificate_figure<&Certificate::forearm_error_mean>, true},
    {"swivel_error", "swivel angle", "deg", kDegreesPerRadian, 1, 1,
     certificate_figure<&Certificate::swivel_error_mean>, true},
    {"palm_error", "palm", "deg", kDegreesPerRadian, 1, 1,
     certificate_figure<&Certificate::palm_error_mean>},
    {"wrist_speed_correlation", "wrist speed r", "", 1, 2, -1,
     certificate_figure<&Certificate::wrist_speed_correlation>},
    {"clearance", "clearance", "mm", 1e3, 1, -1, certificate_figure<&Certificate::clearance>},
    {"duration_ratio", "duration ratio", "", 1, 2, 1,
     certificate_figure<&Certificate::duration_ratio>},
    {"duration", "duration", "s", 1, 2, 1, duration},
}};

}  // namespace

const std::array<PlanFigure, kPlanFigureCount>& plan_figures() { return kFigures; }

int figure_index(std::string_view key) {
  int k = 0;
  while (k < kPlanFigureCount && kFigures[k].key != key) ++k;
  return k;
}

FigureValues figures_of(const RobotModel& robot, const Plan& plan) {
  FigureValues values;
  for (int k = 0; k < kPlanFigureCount; ++k) values[k] = kFigures[k].compute(robot, plan);
  return values;
}

double median_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return math::midpoint_median(std::move(values));
}

std::string format_figure(const PlanFigure& figure, double value, bool arm_estimated) {
  if (std::isnan(value)) return "-";
  return fmt::format("{}{:.{}f}", arm_estimated && figure.uses_human_arm ? "~" : "",
                     figure.print_scale * value, figure.digits);
}

}  // namespace morphe::commands
