#include "pipeline/commands/plan_diff.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/motion/input_error.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/commands/verdict.hpp"
#include "pipeline/run/config_changes.hpp"

namespace morphe::commands {
namespace {

/// Returns the row of a plan; of one that cannot be read, a row "damaged" with the error.
PlanRow read_row(const store::PlanReader& plans, const robot::Robot& robot, const Verdict& verdict,
                 std::size_t index) {
  try {
    PlanRow row = row_of(robot, plans.read(index));
    distrust(row, verdict.violation_of(row.name));
    return row;
  } catch (const InputError& error) {
    PlanRow row;
    row.name = plans.plan_paths()[index];
    row.status = "damaged";
    row.figures.fill(kUnknown);
    row.lines = {error.what()};
    return row;
  }
}

/// Returns the verdict; on a file that cannot be read to its end, one that rejects it.
Verdict verdict_on_damaged(const std::filesystem::path& plans, int jobs) {
  try {
    return verdict_on(plans, jobs);
  } catch (const InputError& error) {
    return {{{"", error.what()}}, error.what(), 1};
  }
}

std::vector<PlanPair> pairs_of(const store::PlanReader& first, const store::PlanReader& second,
                               const Verdict& on_first, const Verdict& on_second) {
  const robot::Robot robot_of_first(first.robot()), robot_of_second(second.robot());
  std::vector<PlanPair> pairs;
  std::map<std::string, std::size_t> pair_of;
  for (std::size_t k = 0; k < first.size(); ++k) {
    pair_of[first.plan_paths()[k]] = pairs.size();
    pairs.push_back({first.plan_paths()[k], read_row(first, robot_of_first, on_first, k), {}});
  }
  for (std::size_t k = 0; k < second.size(); ++k) {
    const auto [entry, is_new] = pair_of.emplace(second.plan_paths()[k], pairs.size());
    if (is_new) pairs.push_back({second.plan_paths()[k], {}, {}});
    pairs[entry->second].second = read_row(second, robot_of_second, on_second, k);
  }
  return pairs;
}

FigureChange change_of(const std::vector<PlanPair>& pairs, int figure) {
  FigureChange change;
  std::vector<double> before, after;
  for (const PlanPair& pair : pairs) {
    const double difference = pair.change(figure);
    if (std::isnan(difference)) continue;
    ++change.plans;
    before.push_back(pair.first->figures[figure]);
    after.push_back(pair.second->figures[figure]);
    if (std::abs(difference) <= std::abs(change.max_change)) continue;
    change.max_change = difference;
    change.plan = pair.name;
  }
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
  const auto differs = [&](std::string_view path) {
    return std::ranges::any_of(data.differences, [&](const run::Difference& difference) {
      return difference.plan.empty() && difference.dataset.starts_with(path);
    });
  };
  if (differs("robot/") || differs("@robot")) changes.emplace_back("another robot");
  if (differs("inputs")) changes.emplace_back("configs with different text");
  return changes;
}

}  // namespace

bool PlanPair::status_changed() const {
  return in_both() && (first->status != second->status || first->reason != second->reason);
}

double PlanPair::change(int figure) const {
  return in_both() ? second->figures[figure] - first->figures[figure] : kUnknown;
}

PlanDiff compare_plans(const std::filesystem::path& first, const std::filesystem::path& second,
                       bool unverified, int jobs) {
  const store::PlanReader a(first), b(second);
  const Verdict on_a = unverified ? Verdict() : verdict_on_damaged(first, jobs);
  const Verdict on_b = unverified ? Verdict() : verdict_on_damaged(second, jobs);
  PlanDiff diff{
      first, second, on_a.text(), on_b.text(), {}, {}, {}, {}, run::diff_files(first, second)};
  if (unverified) diff.first_not_verified = diff.second_not_verified = kNotJudged;
  diff.pairs = pairs_of(a, b, on_a, on_b);
  for (int k = 0; k < kPlanFigureCount; ++k) diff.figures[k] = change_of(diff.pairs, k);
  if (a.header().config != b.header().config)
    diff.config_changes = run::config_changes(a.header().config, b.header().config);
  diff.file_changes = file_changes(a.header(), b.header(), diff.dataset_differences);
  return diff;
}

std::vector<PlanPair> select_pairs(const PlanDiff& diff, const RowSelection& choice) {
  std::vector<PlanPair> pairs;
  for (const PlanPair& pair : diff.pairs)
    if ((pair.first && is_selected(choice, *pair.first)) ||
        (pair.second && is_selected(choice, *pair.second)))
      pairs.push_back(pair);
  if (choice.sort_key == "name") std::ranges::stable_sort(pairs, {}, &PlanPair::name);
  const int figure = figure_index(choice.sort_key);
  if (figure == kPlanFigureCount) return pairs;
  std::ranges::stable_sort(pairs, std::ranges::greater{}, [&](const PlanPair& pair) {
    const double change = pair.change(figure);
    return std::isnan(change) ? -1 : std::abs(change);
  });
  return pairs;
}

}  // namespace morphe::commands
