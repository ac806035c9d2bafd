#include "stages/export/plan_selection.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "stages/export/table/condition.hpp"

namespace morphe::exports {

PlanSelection select_plans(const store::PlanReader& reader, const std::string& where,
                           const SplitOptions& split) {
  std::optional<Condition> condition;
  if (!where.empty()) condition.emplace(where);
  PlanSelection selection;
  std::vector<std::string> keys;
  const auto read_all = [&](const auto& visit) {
    for (std::size_t i = 0; i < reader.size(); ++i) visit(i, reader.read(i));
  };
  // The sides depend on the keys of all plans, so that a condition does not change them.
  if (split.by != SplitBy::none)
    read_all([&](std::size_t, const Plan& plan) { keys.push_back(split_key(plan, split.by)); });
  const std::vector<std::string_view> sides = split_sides(keys, split.validation_share);
  read_all([&](std::size_t i, const Plan& plan) {
    const std::string_view side = sides.empty() ? "" : sides[i];
    selection.counts.add(plan);
    if (condition && !condition->holds({reader.robot(), plan, side})) return;
    selection.plans.push_back({i, side});
  });
  if (condition && selection.plans.empty())
    throw InputError(fmt::format("--where '{}': none of {} satisfies it", where,
                                 count_with_noun(reader.size(), "plan")));
  return selection;
}

}  // namespace morphe::exports
