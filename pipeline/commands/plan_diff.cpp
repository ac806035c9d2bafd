#include "pipeline/commands/plan_diff.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/motion/input_error.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/run/config_changes.hpp"

namespace morphe::commands {
namespace {

/// Reads a plan as a row. If it cannot be read, the row contains the error; its datasets are
/// compared nevertheless.
PlanRow read_row(const store::PlanReader& plans, const robot::Robot& robot, std::size_t index) {
  try {
    return row_of(robot, plans.read(index));
  } catch (const InputError& error) {
    PlanRow row;
    row.name = plans.plan_paths()[index];
    row.status = "damaged";
    row.figures.fill(kUnknown);
    row.lines = {error.what()};
    return row;
  }
}

std::vector<PlanPair> pairs_of(const store::PlanReader& first, const store::PlanReader& second) {
  const robot::Robot robot_of_first(first.robot()), robot_of_second(second.robot());
  std::vector<PlanPair> pairs;
  std::map<std::string, std::size_t> at;
  for (std::size_t k = 0; k < first.size(); ++k) {
    at[first.plan_paths()[k]] = pairs.size();
    pairs.push_back({first.plan_paths()[k], read_row(first, robot_of_first, k), {}});
  }
  for (std::size_t k = 0; k < second.size(); ++k) {
    const std::string& name = second.plan_paths()[k];
    const auto found = at.find(name);
    PlanPair& pair =
        found == at.end() ? pairs.emplace_back(PlanPair{name, {}, {}}) : pairs[found->second];
    pair.second = read_row(second, robot_of_second, k);
  }
  return pairs;
}

FigureChange change_of(const std::vector<PlanPair>& pairs, std::size_t figure) {
  FigureChange change;
  std::vector<double> before, after;
  for (const PlanPair& pair : pairs) {
    const double moved = pair.change(figure);
    if (std::isnan(moved)) continue;
    before.push_back(pair.first->figures[figure]);
    after.push_back(pair.second->figures[figure]);
    if (std::abs(moved) <= std::abs(change.max_change)) continue;
    change.max_change = moved;
    change.plan = pair.name;
  }
  change.plans = before.size();
  change.median_first = median_of(before);
  change.median_second = median_of(after);
  return change;
}

std::vector<std::string> file_changes(const PlanFileHeader& a, const PlanFileHeader& b,
                                      const run::DiffReport& data) {
  std::vector<std::string> changes;
  if (a.dataset_sha256 != b.dataset_sha256) changes.emplace_back("another dataset");
  if (a.software != b.software) changes.push_back(a.software + " -> " + b.software);
  if (a.built_with != b.built_with) changes.emplace_back("another build");
  const auto begins = [&](std::string_view what) {
    return std::ranges::any_of(data.differences, [&](const run::Difference& difference) {
      return difference.plan.empty() && difference.dataset.starts_with(what);
    });
  };
  if (begins("robot/") || begins("@robot")) changes.emplace_back("another robot");
  if (begins("inputs")) changes.emplace_back("configs with different text");
  return changes;
}

}  // namespace

bool PlanPair::status_changed() const {
  return in_both() && (first->status != second->status || first->reason != second->reason);
}

double PlanPair::change(std::size_t figure) const {
  return in_both() ? second->figures[figure] - first->figures[figure] : kUnknown;
}

PlanDiff compare_plans(const std::filesystem::path& first, const std::filesystem::path& second) {
  PlanDiff diff{first, second, {}, {}, {}, {}, run::diff_files(first, second)};
  const store::PlanReader a(first), b(second);
  diff.pairs = pairs_of(a, b);
  for (std::size_t k = 0; k < kPlanFigureCount; ++k) diff.figures[k] = change_of(diff.pairs, k);
  if (a.header().config != b.header().config)
    diff.config_changes = run::config_changes(a.header().config, b.header().config);
  diff.file_changes = file_changes(a.header(), b.header(), diff.dataset_differences);
  return diff;
}

std::vector<PlanPair> select_pairs(const PlanDiff& diff, const RowSelection& choice) {
  std::vector<PlanPair> pairs;
  for (const PlanPair& pair : diff.pairs) {
    if ((pair.first && is_selected(choice, *pair.first)) ||
        (pair.second && is_selected(choice, *pair.second)))
      pairs.push_back(pair);
  }
  if (choice.sort_key == "name") std::ranges::stable_sort(pairs, {}, &PlanPair::name);
  const auto& figures = plan_figures();
  const auto key = std::ranges::find(figures, choice.sort_key, &PlanFigure::key);
  if (key == figures.end()) return pairs;
  const auto k = static_cast<std::size_t>(key - figures.begin());
  std::ranges::stable_sort(pairs, std::ranges::greater{}, [&](const PlanPair& pair) {
    const double moved = pair.change(k);
    return std::isnan(moved) ? -1 : std::abs(moved);
  });
  return pairs;
}

}  // namespace morphe::commands
