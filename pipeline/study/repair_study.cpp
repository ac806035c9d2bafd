#include <fmt/format.h>

#include <algorithm>

#include "core/math/statistics.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/study/obstacles.hpp"
#include "pipeline/study/repair_case.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {
namespace {

void add_rows(const RepairStudyOptions& options, const std::string& kind,
              const std::vector<ObstacleCase>& cases, StudyResult& result) {
  std::vector<const ObstacleCase*> of_kind;
  for (const ObstacleCase& one : cases) {
    if (kind == "all" || one.kind == kind) of_kind.push_back(&one);
  }
  if (of_kind.empty()) return;
  double ours_a = kUnknown;
  std::vector<StudyVariant> variants = options.variants;
  variants.push_back(options.planner_only);
  for (std::size_t v = 0; v < variants.size(); ++v) {
    std::size_t solved = 0, solvable = 0, collisions = 0, changed = 0;
    std::vector<double> a_ratio, tips, both_a, both_tips;
    for (const ObstacleCase* one : of_kind) {
      const RepairOutcome& repaired = one->variants[v];
      solved += repaired.executable ? 1 : 0;
      solvable +=
          one->variants.front().executable || one->found_by_long_search || repaired.executable ? 1
                                                                                               : 0;
      collisions += repaired.colliding_states;
      changed += repaired.mapped_samples_changed ? 1 : 0;
      if (!repaired.executable) continue;
      a_ratio.push_back(repaired.humanlikeness_ratio);
      tips.push_back(repaired.mean_tip_error_m);
      if (!std::ranges::all_of(one->variants, &RepairOutcome::executable)) continue;
      both_a.push_back(repaired.humanlikeness_ratio);
      both_tips.push_back(repaired.mean_tip_error_m);
    }
    const bool first = v == 0, whole = kind == "all";
    const Case of = {{"obstacle", kind}, {"variant", variants[v].name}};
    const auto row = [&](const char* metric, const char* unit, double value,
                         std::size_t n) -> StudyRow& {
      result.rows.push_back(make_row(of, metric, unit, value, n));
      return result.rows.back();
    };
    row("executable", "1", static_cast<double>(solved) / static_cast<double>(of_kind.size()),
        of_kind.size());
    StudyRow& share = row("executable share of solvable cases", "1",
                          static_cast<double>(solved) / static_cast<double>(solvable), solvable);
    if (first && whole) share.at_least = 0.98;
    StudyRow& hits = row("states in collision", "1", static_cast<double>(collisions), solved);
    if (first) hits.at_most = 0;
    StudyRow& bits =
        row("change outside the repaired intervals", "1", static_cast<double>(changed), solved);
    if (first) bits.at_most = 0;
    StudyRow& a =
        row("A over A of the mapping, median", "1", math::quantile(a_ratio, 0.5), a_ratio.size());
    if (first && whole) a.at_most = 1.25;
    row("tip error, mean", "m", math::mean(tips), tips.size());
    StudyRow& common = row("A over A of the mapping, cases solved by all, mean", "1",
                           math::mean(both_a), both_a.size());
    if (first) {
      ours_a = common.ours;
    } else if (whole) {
      common.at_least = ours_a;  // requires that ours is not worse
    }
    row("tip error, cases solved by all, mean", "m", math::mean(both_tips), both_tips.size());
  }
}

}  // namespace

std::string validation_error(const RepairStudyOptions& o) {
  if (o.variants.empty()) return "variants is empty";
  if (o.cases < 1 || o.quick_cases < 1) return "cases and quick_cases must be positive";
  if (o.recordings < 1) return "recordings must be positive";
  if (o.first_recording < 0) return "first_recording must not be negative";
  if (!(o.check_step_m > 0)) return "check_step_m must be positive";
  return "";
}

StudyResult repair_study(const config::ConfigNode& config, const StudyRun& run) {
  RepairStudyOptions options;
  config::read_document(config, options);
  const std::filesystem::path folder = run.config.parent_path();
  RepairStudy study{options, folder / options.pipeline, {}};
  const config::ConfigNode node = config::ConfigNode::load(folder / options.synthetic);
  config::read_document(node, study.synthetic);

  std::vector<planning::LoadedConfig> variants, long_searches;
  for (const StudyVariant& variant : options.variants) {
    variants.push_back(planning::load_config(study.pipeline, variant.set));
  }
  for (const std::uint64_t seed : options.long_seeds) {
    if (run.quick) break;
    std::vector<std::string> set = options.long_search.set;
    set.push_back(fmt::format("seed={}", seed));
    long_searches.push_back(planning::load_config(study.pipeline, set));
  }

  const planning::LoadedConfig plain =
      planning::load_config(study.pipeline, options.planner_only.set);

  const auto wanted = static_cast<std::size_t>(run.quick ? options.quick_cases : options.cases);
  std::vector<ObstacleCase> cases;
  std::size_t looked_at = 0;
  parallel::OrderedParallelMap<std::uint64_t, ObstacleCase> map;
  const int end = options.first_recording + options.recordings;
  map.next = [&, next = options.first_recording]() mutable {
    return cases.size() >= wanted || next == end
               ? nullptr
               : std::make_unique<std::uint64_t>(static_cast<std::uint64_t>(next++));
  };
  map.work = [&](const std::uint64_t& index) {
    return std::make_unique<ObstacleCase>(run_case(study, variants, plain, long_searches, index));
  };
  map.write = [&](const ObstacleCase& one) {
    if (cases.size() >= wanted) return;  // started before it was clear that enough cases are found
    ++looked_at;
    if (!one.is_valid) return;
    cases.push_back(one);
    std::string line = fmt::format("{} of {} cases, recording {}, {}:", cases.size(), wanted,
                                   one.recording, one.kind);
    for (const RepairOutcome& repaired : one.variants) {
      line += repaired.executable
                  ? fmt::format(" A {:.2f}, tips {:.1f} mm;", repaired.humanlikeness_ratio,
                                1e3 * repaired.mean_tip_error_m)
                  : fmt::format(" {};", repaired.failure);
    }
    if (one.found_by_long_search) line += " found by the long search";
    run.progress(line);
  };
  morphe::parallel::run(map, run.jobs);

  StudyResult result;
  result.rows.push_back(make_row({{"obstacle", "all"}}, "recordings examined", "1",
                                 static_cast<double>(looked_at), cases.size()));
  add_rows(options, "all", cases, result);
  for (const char* kind : kObstacleKinds) add_rows(options, kind, cases, result);
  return result;
}

}  // namespace morphe::study
