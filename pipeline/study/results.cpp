#include "pipeline/study/results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/files/atomic_file.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::study {
namespace {

using Json = nlohmann::ordered_json;

std::string requirement_text(const StudyRow& row) {
  if (!std::isnan(row.at_least)) return fmt::format(">= {:.4g}", row.at_least);
  if (!std::isnan(row.at_most)) return fmt::format("<= {:.4g}", row.at_most);
  return "";
}

std::string case_text(const StudyRow& row) {
  std::string text;
  for (const auto& [name, value] : row.case_values) text += (text.empty() ? "" : "; ") + value;
  return text;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

StudyResult remove_timed_rows(StudyResult result) {
  std::erase_if(result.rows, [](const StudyRow& row) { return row.is_timing; });
  return result;
}

void write_hdf5(const StudyResult& result, const std::filesystem::path& path) {
  files::AtomicFile part(path);
  store::Hdf5File file = store::Hdf5File::create(part.part());
  const store::Hdf5Group root = file.root();
  store::write_format(root, "morphe-study", 1);
  root.set("study", result.study);
  std::vector<std::string> cases, metrics, units;
  store::Hdf5Array<double> ours, published, reachable, count;
  for (const StudyRow& row : result.rows) {
    cases.push_back(case_text(row));
    metrics.push_back(row.metric);
    units.push_back(row.unit);
    ours.values.push_back(row.ours);
    published.values.push_back(row.published);
    reachable.values.push_back(row.reachable);
    count.values.push_back(static_cast<double>(row.count));
  }
  root.write_strings("case", cases);
  root.write_strings("metric", metrics);
  root.write_strings("units", units);
  for (auto& [name, column] : {std::pair("ours", &ours), std::pair("published", &published),
                               std::pair("reachable", &reachable), std::pair("count", &count)}) {
    column->dims = {column->values.size()};
    root.write(name, *column);
  }
  file.close();
  part.commit();
}

}  // namespace

std::string results_json(const StudyResult& all) {
  const StudyResult result = remove_timed_rows(all);
  Json rows = Json::array();
  for (const StudyRow& row : result.rows) {
    Json case_values = Json::object();
    for (const auto& [name, value] : row.case_values) case_values[name] = value;
    Json json = {{"case", case_values},
                 {"metric", row.metric},
                 {"unit", row.unit},
                 {"ours", number(row.ours)},
                 {"published", number(row.published)},
                 {"reachable", number(row.reachable)},
                 {"count", row.count}};
    if (row.has_requirement()) {
      json["requirement"] = requirement_text(row);
      json["requirement_met"] = row.meets_requirement();
    }
    rows.push_back(std::move(json));
  }
  return Json{{"study", result.study}, {"rows", rows}}.dump(2) + "\n";
}

std::string results_csv(const StudyResult& all) {
  const StudyResult result = remove_timed_rows(all);
  std::string text =
      "case,metric,unit,ours,published,reachable,count,requirement,requirement_met\n";
  const auto cell = [](double v) { return std::isfinite(v) ? fmt::format("{}", v) : ""; };
  for (const StudyRow& row : result.rows) {
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", quoted(case_text(row)), quoted(row.metric),
                        row.unit, cell(row.ours), cell(row.published), cell(row.reachable),
                        row.count, requirement_text(row),
                        row.has_requirement() ? (row.meets_requirement() ? "yes" : "no") : "");
  }
  return text;
}

std::string results_table(const StudyResult& result) {
  std::size_t case_width = 4, metric_width = 6;
  for (const StudyRow& row : result.rows) {
    case_width = std::max(case_width, case_text(row).size());
    metric_width = std::max(metric_width, row.metric.size());
  }
  const auto any_known = [&](double StudyRow::*column) {
    return !std::ranges::all_of(
        result.rows, [](double x) { return std::isnan(x); }, column);
  };
  const bool published = any_known(&StudyRow::published);
  const bool reachable = any_known(&StudyRow::reachable);
  const auto optional = [](bool shown, double value) {
    if (!shown) return std::string();
    return std::isnan(value) ? std::string(11, ' ') : fmt::format(" {:>10.4g}", value);
  };
  std::string text =
      fmt::format("{:<{}}  {:<{}}  {:>10} {:<5}{}{} {:>12}  {:>7}\n", "case", case_width, "metric",
                  metric_width, "ours", "unit", published ? "  published" : "",
                  reachable ? "  reachable" : "", "requirement", "count");
  for (const StudyRow& row : result.rows) {
    text += fmt::format("{:<{}}  {:<{}}  {:>10.4g} {:<5}{}{} {:>12}  {:>7}{}\n", case_text(row),
                        case_width, row.metric, metric_width, row.ours, row.unit,
                        optional(published, row.published), optional(reachable, row.reachable),
                        requirement_text(row), row.count,
                        row.has_requirement() && !row.meets_requirement() ? "  not met" : "");
  }
  return text;
}

void write_results(const StudyResult& all, const std::filesystem::path& folder) {
  const StudyResult result = remove_timed_rows(all);
  files::write_atomically(folder / "results.json", results_json(result));
  files::write_atomically(folder / "results.csv", results_csv(result));
  write_hdf5(result, folder / "results.h5");
  for (const auto& [name, plot] : result.plots)
    files::write_atomically(folder / (name + ".svg"), svg_of(plot));
  for (const auto& [name, grid] : result.grids)
    files::write_atomically(folder / (name + ".svg"), svg_of(grid));
  for (const auto& [name, table] : result.tables)
    files::write_atomically(folder / (name + ".md"), table);
}

}  // namespace morphe::study
