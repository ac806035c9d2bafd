#include "pipeline/report/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/motion/counted.hpp"
#include "core/motion/goals_at.hpp"

namespace morphe::report {
namespace {

double out_of_reach_share(const Plan& plan) {
  const GoalCount count = count_goals(plan.goals);
  return count.all > 0 ? count.share_out_of_reach() : kNotSeen;
}

/// The more, the worse.
struct Badness {
  const char* name;
  double (*of)(const Plan&);
};

constexpr std::array<Badness, 7> kBadness{{
    {"tips", [](const Plan& plan) { return plan.certificate.position_error_max; }},
    {"grasp", [](const Plan& plan) { return plan.certificate.position_error_grasp; }},
    {"clearance", [](const Plan& plan) { return -plan.certificate.clearance; }},
    {"tempo", [](const Plan& plan) { return std::abs(std::log(plan.certificate.tempo)); }},
    {"upper_arm", [](const Plan& plan) { return plan.certificate.upper_arm_error_mean; }},
    {"humanlikeness", [](const Plan& plan) { return plan.certificate.humanlikeness_final; }},
    {"out_of_reach", out_of_reach_share},
}};

std::vector<std::size_t> worst_of(const std::vector<std::size_t>& plans,
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
  std::string what = selection.worst > 0 && shown < matching
                         ? fmt::format("the {} worst by {}", selection.worst, selection.by)
                         : "those";
  if (what != "those" && (!selection.pattern.empty() || selection.failed)) what += " of those";
  if (!selection.pattern.empty()) what += fmt::format(" called {}", selection.pattern);
  if (selection.failed) what += " that are infeasible";
  return fmt::format("{} of {} are left out: shown are {}", all - shown, counted(all, "plan"),
                     what);
}

}  // namespace

std::vector<std::string> worst_by_names() {
  std::vector<std::string> names;
  for (const Badness& badness : kBadness) names.emplace_back(badness.name);
  return names;
}

bool matches(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == '*') {
    return matches(name, pattern.substr(1)) || (!name.empty() && matches(name.substr(1), pattern));
  }
  return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
         matches(name.substr(1), pattern.substr(1));
}

Selected select_plans(const store::PlanReader& reader, const Selection& selection) {
  const auto by = std::ranges::find(kBadness, selection.by, &Badness::name);
  const bool look_inside = selection.failed || selection.worst > 0;
  Selected selected;
  std::vector<double> badness;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    if (!selection.pattern.empty() && !matches(reader.plan_paths()[i], selection.pattern)) continue;
    if (look_inside) {
      const Plan plan = reader.read(i);
      if (selection.failed && plan.has_trajectory()) continue;
      if (selection.worst > 0) badness.push_back(by->of(plan));
    }
    selected.plans.push_back(i);
  }
  const std::size_t matching = selected.plans.size();
  if (selection.worst > 0)
    selected.plans = worst_of(selected.plans, badness, static_cast<std::size_t>(selection.worst));
  selected.left_out = left_out_sentence(selection, reader.size(), matching, selected.plans.size());
  return selected;
}

}  // namespace morphe::report
