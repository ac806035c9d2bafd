#include <nlohmann/json.hpp>

#include "pipeline/commands/branch_text.hpp"
#include "pipeline/commands/plan_diff.hpp"

namespace morphe::commands {
namespace {

using Json = nlohmann::ordered_json;

Json side_json(const std::optional<PlanRow>& row) {
  if (!row) return nullptr;
  Json json{
      {"status", row->status}, {"reason", row->reason}, {"arm_estimated", row->arm_estimated}};
  for (int k = 0; k < kPlanFigureCount; ++k)
    json[std::string(plan_figures()[k].key)] = row->figures[k];
  json["branch"] = row->branch.number ? Json(*row->branch.number) : Json();
  json["branch_words"] = row->branch.words;
  json["branch_changes"] = row->branch.changes;
  return json;
}

Json data_json(const run::Difference& difference) {
  Json row{{"plan", difference.plan}, {"dataset", difference.dataset}};
  row["max_abs"] = nullptr;
  if (difference.max_abs) {
    row["max_abs"] = *difference.max_abs;
    row["unit"] = difference.unit;
    row["at"] = difference.location;
    row["values"] = {difference.first, difference.second};
  }
  row["change"] = difference.change;
  return row;
}

Json status_json(const PlanDiff& diff) {
  Json changes = Json::array();
  for (const PlanPair& pair : diff.pairs) {
    if (!pair.status_changed()) continue;
    const auto side = [](const PlanRow& row) {
      return Json{{"status", row.status},
                  {"reason", row.reason},
                  {"detail", row.lines.empty() ? "" : row.lines.front()}};
    };
    changes.push_back(
        {{"plan", pair.name}, {"first", side(*pair.first)}, {"second", side(*pair.second)}});
  }
  return changes;
}

Json branches_json(const PlanDiff& diff) {
  Json changes = Json::array();
  for (const PlanPair& pair : diff.pairs) {
    if (!pair.in_both()) continue;
    const std::string change = branch_change(pair.first->branch, pair.second->branch);
    if (!change.empty()) changes.push_back({{"plan", pair.name}, {"change", change}});
  }
  return changes;
}

}  // namespace

std::string diff_json(const PlanDiff& diff) {
  Json json{{"equal", diff.equal()},
            {"first_not_verified", diff.first_not_verified},
            {"second_not_verified", diff.second_not_verified}};
  Json only_first = Json::array(), only_second = Json::array(), rows = Json::array();
  int both = 0;
  for (const PlanPair& pair : diff.pairs) {
    both += pair.in_both() ? 1 : 0;
    if (!pair.second) only_first.push_back(pair.name);
    if (!pair.first) only_second.push_back(pair.name);
    rows.push_back({{"plan", pair.name},
                    {"first", side_json(pair.first)},
                    {"second", side_json(pair.second)}});
  }
  json["in_both"] = both;
  json["only_in_first"] = only_first;
  json["only_in_second"] = only_second;
  json["config_changes"] = diff.config_changes;
  json["file_changes"] = diff.file_changes;
  json["status_changes"] = status_json(diff);
  json["branch_changes"] = branches_json(diff);
  json["figures"] = Json::object();
  for (int k = 0; k < kPlanFigureCount; ++k) {
    const FigureChange& change = diff.figures[k];
    json["figures"][std::string(plan_figures()[k].key)] = {{"plans", change.plans},
                                                           {"median_first", change.median_first},
                                                           {"median_second", change.median_second},
                                                           {"max_change", change.max_change},
                                                           {"plan", change.plan}};
  }
  json["rows"] = rows;
  json["differences"] = Json::array();
  for (const run::Difference& difference : diff.dataset_differences.differences)
    json["differences"].push_back(data_json(difference));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace morphe::commands
