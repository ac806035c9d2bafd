#include "pipeline/commands/robots_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/motion/arm_estimate.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/plan_figures.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

std::string format_decimal(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : std::string("-");
}

std::string median(const std::vector<FigureValues>& all, std::string_view key,
                   bool arm_estimated = false) {
  const int k = figure_index(key);
  std::vector<double> values;
  for (const FigureValues& figures : all) values.push_back(figures[k]);
  return format_figure(plan_figures()[k], median_of(values), arm_estimated);
}

TextTable::Row robot_row(const std::string& name, const store::PlanReader& plans) {
  GoalCount goals;
  double tips_m = 0, tips_max_m = kUnknown;
  int executable = 0, repaired = 0;
  bool estimate = false;
  std::vector<FigureValues> moving;  // of plans with a trajectory
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const Plan plan = plans.read(k);
    const GoalCount count = count_goals(plan.goals);
    goals.all += count.all;
    goals.out_of_reach += count.out_of_reach;
    if (!plan.has_trajectory()) continue;
    executable += plan.executable() ? 1 : 0;
    repaired += plan.repaired ? 1 : 0;
    tips_m += plan.certificate.tip_error_mean;
    tips_max_m = std::fmax(tips_max_m, plan.certificate.tip_error_max);
    moving.push_back(figures_of(plans.robot(), plan));
    estimate = estimate || is_arm_estimated(plan.goals);
  }
  return {{name, fmt::format("{} of {}", executable, plans.size()), fmt::format("{}", repaired),
           format_decimal(
               100 * static_cast<double>(goals.out_of_reach) / static_cast<double>(goals.all), 1),
           format_decimal(1e3 * tips_m / static_cast<double>(moving.size()), 2),
           format_decimal(1e3 * tips_max_m, 2), median(moving, "humanlikeness", estimate),
           median(moving, "upper_arm_error", estimate), median(moving, "forearm_error", estimate),
           median(moving, "swivel_error", estimate), median(moving, "palm_error"),
           median(moving, "wrist_speed_correlation"), median(moving, "duration_ratio")},
          {}};
}

}  // namespace

std::string robots_table(const std::vector<std::pair<std::string, std::filesystem::path>>& robots,
                         std::size_t width) {
  TextTable table;
  table.columns = {{"robot", "", true, 0},
                   {"executable", "", false, 0},
                   {"repaired", "", false, 5},
                   {"out of", "reach %", false, 1},
                   {"tips", "mean mm", false, 3},
                   {"tips", "max mm", false, 2},
                   {"human-", "like cm^2", false, 10},
                   {"upper arm", "median deg", false, 6},
                   {"forearm", "median deg", false, 8},
                   {"swivel", "median deg", false, 9},
                   {"palm", "median deg", false, 4},
                   {"wrist", "speed r med.", false, 7},
                   {"duration", "ratio med.", false, 2}};
  for (const auto& [name, plans] : robots)
    table.rows.push_back(robot_row(name, store::PlanReader(plans)));
  return table_text(table, width);
}

}  // namespace morphe::commands
