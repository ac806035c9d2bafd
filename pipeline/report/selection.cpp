#include "pipeline/report/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/goal_interpolation.hpp"

namespace morphe::report {
namespace {

double unreachable_share(const Plan& plan) {
  const GoalCount count = count_goals(plan.goals);
  return count.all > 0 ? count.share_out_of_reach() : kUnknown;
}

/// A measure by which plans are ranked; larger values are worse.
struct RankingMeasure {
  const char* name;
  double (*value)(const Plan&);
};

constexpr std::array<RankingMeasure, 11> kRankingMeasures{{
    {"tip_error_max", [](const Plan& plan) { return plan.certificate.tip_error_max; }},
    {"tip_error_grasp", [](const Plan& plan) { return plan.certificate.tip_error_grasp; }},
    {"clearance", [](const Plan& plan) { return -plan.certificate.clearance; }},
    {"duration_ratio",
     [](const Plan& plan) { return std::abs(std::log(plan.certificate.duration_ratio)); }},
    {"upper_arm_error", [](const Plan& plan) { return plan.certificate.upper_arm_error_mean; }},
    {"forearm_error", [](const Plan& plan) { return plan.certificate.forearm_error_mean; }},
    {"swivel_error", [](const Plan& plan) { return plan.certificate.swivel_error_mean; }},
    {"palm_error", [](const Plan& plan) { return plan.certificate.palm_error_mean; }},
    {"wrist_speed_correlation",
     [](const Plan& plan) { return -plan.certificate.wrist_speed_correlation; }},
    {"humanlikeness", [](const Plan& plan) { return plan.certificate.humanlikeness_final; }},
    {"unreachable_share", unreachable_share},
}};

/// Returns the `count` plans with the greatest values, in the order of `plans`.
std::vector<int> select_worst(const std::vector<int>& plans, const std::vector<double>& values,
                              int count) {
  std::vector<int> order(plans.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](int i) { return std::isnan(values[i]) ? -kInfinity : values[i]; };
  std::ranges::stable_sort(order, std::ranges::greater{}, rank);
  if (count < std::ssize(order)) order.resize(count);
  std::ranges::sort(order);
  std::vector<int> selected;
  for (const int i : order) selected.push_back(plans[i]);
  return selected;
}

std::string left_out_sentence(const Selection& selection, std::size_t all, std::size_t matching,
                              std::size_t shown) {
  if (shown == all) return "";
  const bool is_ranked = selection.worst_count > 0 && shown < matching;
  std::string description = "those";
  if (is_ranked) {
    description =
        fmt::format("the {} worst by {}", selection.worst_count, selection.ranking_measure);
    if (!selection.pattern.empty() || selection.infeasible_only) description += " of those";
  }
  if (!selection.pattern.empty())
    description += fmt::format(" with the name {}", selection.pattern);
  if (selection.infeasible_only) description += " that are infeasible";
  return fmt::format("{} of {} are hidden; shown are {}", all - shown, count_with_noun(all, "plan"),
                     description);
}

}  // namespace

std::vector<std::string> ranking_measure_names() {
  std::vector<std::string> names;
  for (const RankingMeasure& measure : kRankingMeasures) names.emplace_back(measure.name);
  return names;
}

bool matches_pattern(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == '*') {
    return matches_pattern(name, pattern.substr(1)) ||
           (!name.empty() && matches_pattern(name.substr(1), pattern));
  }
  return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
         matches_pattern(name.substr(1), pattern.substr(1));
}

bool plan_matches(std::string_view path, std::string_view pattern) {
  return matches_pattern(path, pattern) ||
         matches_pattern(path.substr(0, path.rfind('/')), pattern);
}

SelectedPlans select_plans(const store::PlanReader& reader, const Selection& selection) {
  const auto measure =
      std::ranges::find(kRankingMeasures, selection.ranking_measure, &RankingMeasure::name);
  const bool reads_plans = selection.infeasible_only || selection.worst_count > 0;
  SelectedPlans selected;
  std::vector<double> values;
  const std::vector<std::string>& paths = reader.plan_paths();
  for (int i = 0; i < std::ssize(paths); ++i) {
    if (!selection.pattern.empty() && !plan_matches(paths[i], selection.pattern)) continue;
    if (reads_plans) {
      const Plan plan = reader.read(i);
      if (selection.infeasible_only && plan.has_trajectory()) continue;
      if (selection.worst_count > 0) values.push_back(measure->value(plan));
    }
    selected.plans.push_back(i);
  }
  const std::size_t matching = selected.plans.size();
  if (selection.worst_count > 0)
    selected.plans = select_worst(selected.plans, values, selection.worst_count);
  selected.left_out = left_out_sentence(selection, reader.size(), matching, selected.plans.size());
  return selected;
}

}  // namespace morphe::report
