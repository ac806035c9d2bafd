#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/run/diff.hpp"

namespace morphe::run {

std::string diff_json(const DiffReport& report) {
  nlohmann::ordered_json plans = nlohmann::ordered_json::array();
  for (const Difference& difference : report.differences) {
    nlohmann::ordered_json row{{"plan", difference.plan}, {"dataset", difference.dataset}};
    row["max_abs"] = nullptr;
    if (difference.max_abs) row["max_abs"] = *difference.max_abs;
    row["change"] = difference.change;
    plans.push_back(std::move(row));
  }
  const nlohmann::ordered_json json{{"equal", report.differences.empty()}, {"plans", plans}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string diff_text(const DiffReport& report) {
  if (report.differences.empty()) return fmt::format("equal: {} plans\n", report.plans);
  std::string text;
  std::set<std::string> plans;
  for (const Difference& difference : report.differences) {
    if (!difference.plan.empty()) plans.insert(difference.plan);
    text += difference.plan.empty() ? "the file" : difference.plan;
    if (!difference.dataset.empty()) text += " " + difference.dataset;
    text += ":";
    if (difference.max_abs) text += fmt::format(" by at most {:.6g}", *difference.max_abs);
    if (!difference.change.empty()) text += " " + difference.change;
    text += "\n";
  }
  return text + fmt::format("{} of {} plans differ\n", plans.size(), report.plans);
}

}  // namespace morphe::run
