#include "stages/commands/robots_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/planning/palm_error.hpp"

namespace morphe::commands {
namespace {

std::string median(std::vector<double> values, double unit, int digits) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return "-";
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const double middle = n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
  return fmt::format("{:.{}f}", middle / unit, digits);
}

}  // namespace

std::string robots_table_head() {
  return fmt::format(
      "{:<24} {:>11} {:>8} {:>8} {:>8} {:>8} {:>10} {:>10} {:>7}\n"
      "{:<24} {:>11} {:>8} {:>8} {:>8} {:>8} {:>10} {:>10} {:>7}",
      "robot", "executable", "repaired", "out of", "tips", "tips", "upper arm", "palm", "tempo", "",
      "", "", "reach %", "mean mm", "max mm", "median deg", "median deg", "median");
}

std::string robots_row(const std::string& name, const store::PlanReader& plans) {
  std::size_t goals = 0, out_of_reach = 0;
  int executable = 0, repaired = 0;
  double tips_m = 0, tips_max_m = kNotSeen;
  std::vector<double> upper_arm, palm, tempo;
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const Plan plan = plans.read(k);
    for (std::size_t i = 0; i < plan.goals.tip_position.values.size(); ++i) {
      if (!seen(plan.goals.tip_position.values[i])) continue;
      ++goals;
      out_of_reach += plan.goals.reachable.values[i] == 0 ? 1U : 0U;
    }
    if (!plan.executable()) continue;
    const Certificate& c = plan.certificate;
    ++executable;
    repaired += c.repaired ? 1 : 0;
    tips_m += c.position_error_mean;
    tips_max_m = std::fmax(tips_max_m, c.position_error_max);
    upper_arm.push_back(c.upper_arm_error_mean);
    palm.push_back(planning::palm_error(plans.robot(), plan));
    tempo.push_back(c.tempo);
  }
  const auto number = [](double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : std::string("-");
  };
  return fmt::format(
      "{:<24} {:>11} {:>8} {:>8} {:>8} {:>8} {:>10} {:>10} {:>7}", name,
      fmt::format("{} of {}", executable, plans.size()), repaired,
      number(100 * static_cast<double>(out_of_reach) / static_cast<double>(goals), 1),
      number(1e3 * tips_m / executable, 2), number(1e3 * tips_max_m, 2),
      median(upper_arm, kDegree, 1), median(palm, kDegree, 1), median(tempo, 1, 2));
}

}  // namespace morphe::commands
