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
  double (*of)(const Plan&);
};

constexpr std::array<RankingMeasure, 7> kRankingMeasures{{
    {"tip_error_max", [](const Plan& plan) { return plan.certificate.tip_error_max; }},
    {"tip_error_grasp", [](const Plan& plan) { return plan.certificate.tip_error_grasp; }},
    {"clearance", [](const Plan& plan) { return -plan.certificate.clearance; }},
    {"tempo", [](const Plan& plan) { return std::abs(std::log(plan.certificate.duration_ratio)); }},
    {"upper_arm_error", [](const Plan& plan) { return plan.certificate.upper_arm_error_mean; }},
    {"humanlikeness", [](const Plan& plan) { return plan.certificate.humanlikeness_final; }},
    {"unreachable_share", unreachable_share},
}};

std::vector<std::size_t> select_worst(const std::vector<std::size_t>& plans,
                                      const std::vector<double>& badness, std::size_t count) {
  std::vector<std::size_t> order(plans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) { return std::isnan(badness[i]) ? -kInfinity : badness[i]; };
  std::ranges::stable_sort(order, std::ranges::greater{}, rank);
  order.resize(std::min(count, order.size()));
  std::ranges::sort(order);
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) chosen.push_back(plans[i]);
  return chosen;
}

std::string left_out_sentence(const Selection& selection, std::size_t all, std::size_t matching,
                              std::size_t shown) {
  if (shown == all) return "";
  std::string what =
      selection.worst_count > 0 && shown < matching
          ? fmt::format("the {} worst by {}", selection.worst_count, selection.ranking_measure)
          : "those";
  if (what != "those" && (!selection.pattern.empty() || selection.infeasible_only))
    what += " of those";
  if (!selection.pattern.empty()) what += fmt::format(" with the name {}", selection.pattern);
  if (selection.infeasible_only) what += " that are infeasible";
  return fmt::format("{} of {} are hidden; shown are {}", all - shown, count_with_noun(all, "plan"),
                     what);
}

}  // namespace

std::vector<std::string> ranking_measure_names() {
  std::vector<std::string> names;
  for (const RankingMeasure& badness : kRankingMeasures) names.emplace_back(badness.name);
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

SelectedPlans select_plans(const store::PlanReader& reader, const Selection& selection) {
  const auto by =
      std::ranges::find(kRankingMeasures, selection.ranking_measure, &RankingMeasure::name);
  const bool look_inside = selection.infeasible_only || selection.worst_count > 0;
  SelectedPlans selected;
  std::vector<double> badness;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    if (!selection.pattern.empty() && !matches_pattern(reader.plan_paths()[i], selection.pattern))
      continue;
    if (look_inside) {
      const Plan plan = reader.read(i);
      if (selection.infeasible_only && plan.has_trajectory()) continue;
      if (selection.worst_count > 0) badness.push_back(by->of(plan));
    }
    selected.plans.push_back(i);
  }
  const std::size_t matching = selected.plans.size();
  if (selection.worst_count > 0)
    selected.plans = select_worst(selected.plans, badness, selection.worst_count);
  selected.left_out = left_out_sentence(selection, reader.size(), matching, selected.plans.size());
  return selected;
}

}  // namespace morphe::report
