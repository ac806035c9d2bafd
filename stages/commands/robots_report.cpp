#include "stages/commands/robots_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/store/plan_file.hpp"
#include "stages/commands/plan_figures.hpp"
#include "stages/commands/text_table.hpp"

namespace morphe::commands {
namespace {

std::string decimal(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : std::string("-");
}

std::string median(const std::vector<FigureValues>& all, std::string_view key) {
  const auto& figures = plan_figures();
  const auto k =
      static_cast<std::size_t>(std::ranges::find(figures, key, &PlanFigure::key) - figures.begin());
  std::vector<double> values;
  for (const FigureValues& one : all) values.push_back(one[k]);
  return printed(figures[k], median_of(values));
}

TextTable::Row robot_row(const std::string& name, const store::PlanReader& plans) {
  double goals = 0, out_of_reach = 0, tips_m = 0, tips_max_m = kNotSeen;
  int repaired = 0;
  std::vector<FigureValues> executable;
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const Plan plan = plans.read(k);
    for (std::size_t i = 0; i < plan.goals.tip_position.values.size(); ++i) {
      if (!seen(plan.goals.tip_position.values[i])) continue;
      goals += 1;
      out_of_reach += plan.goals.reachable.values[i] == 0 ? 1 : 0;
    }
    if (!plan.executable()) continue;
    repaired += plan.certificate.repaired ? 1 : 0;
    tips_m += plan.certificate.position_error_mean;
    tips_max_m = std::fmax(tips_max_m, plan.certificate.position_error_max);
    executable.push_back(figures_of(plans.robot(), plan));
  }
  return {
      {name, fmt::format("{} of {}", executable.size(), plans.size()), fmt::format("{}", repaired),
       decimal(100 * out_of_reach / goals, 1),
       decimal(1e3 * tips_m / static_cast<double>(executable.size()), 2),
       decimal(1e3 * tips_max_m, 2), median(executable, "humanlikeness"),
       median(executable, "upper_arm"), median(executable, "palm"), median(executable, "tempo")},
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
                   {"human-", "like cm^2", false, 4},
                   {"upper arm", "median deg", false, 6},
                   {"palm", "median deg", false, 7},
                   {"tempo", "median", false, 2}};
  for (const auto& [name, plans] : robots)
    table.rows.push_back(robot_row(name, store::PlanReader(plans)));
  return table_text(table, width);
}

}  // namespace morphe::commands
