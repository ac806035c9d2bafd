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
  const bool all_kinds = kind == "all";
  std::vector<const ObstacleCase*> selected;
  for (const ObstacleCase& candidate : cases) {
    if (all_kinds || candidate.kind == kind) selected.push_back(&candidate);
  }
  if (selected.empty()) return;
  double our_a_ratio = kUnknown;
  std::vector<StudyVariant> variants = options.variants;
  variants.push_back(options.planner_only);
  for (int v = 0; v < std::ssize(variants); ++v) {
    int solved = 0, solvable = 0, collisions = 0, changed = 0;
    std::vector<double> a_ratio, tips, common_a_ratio, common_tips;
    for (const ObstacleCase* obstacle_case : selected) {
      const RepairOutcome& repaired = obstacle_case->variants[v];
      const bool otherwise_solvable =
          obstacle_case->variants.front().executable || obstacle_case->found_by_long_search;
      solved += repaired.executable ? 1 : 0;
      solvable += repaired.executable || otherwise_solvable ? 1 : 0;
      collisions += repaired.colliding_states;
      changed += repaired.mapped_samples_changed ? 1 : 0;
      if (!repaired.executable) continue;
      a_ratio.push_back(repaired.humanlikeness_ratio);
      tips.push_back(repaired.mean_tip_error_m);
      if (!std::ranges::all_of(obstacle_case->variants, &RepairOutcome::executable)) continue;
      common_a_ratio.push_back(repaired.humanlikeness_ratio);
      common_tips.push_back(repaired.mean_tip_error_m);
    }
    const bool ours = v == 0;
    const Case condition = {{"obstacle", kind}, {"variant", variants[v].name}};
    const auto row = [&](auto... values) -> StudyRow& { return result.add(condition, values...); };
    row("executable", "1", solved / static_cast<double>(selected.size()), selected.size());
    StudyRow& solved_share = row("executable share of solvable cases", "1",
                                 solved / static_cast<double>(solvable), solvable);
    if (ours && all_kinds) solved_share.at_least = 0.98;
    row("states in collision", "1", collisions, solved).at_most = ours ? 0 : kUnknown;
    row("change outside the repaired intervals", "1", changed, solved).at_most =
        ours ? 0 : kUnknown;
    StudyRow& median =
        row("A over A of the mapping, median", "1", math::quantile(a_ratio, 0.5), a_ratio.size());
    if (ours && all_kinds) median.at_most = 1.25;
    row("tip error, mean", "m", math::mean(tips), tips.size());
    StudyRow& common = row("A over A of the mapping, cases solved by all, mean", "1",
                           math::mean(common_a_ratio), common_a_ratio.size());
    if (ours)
      our_a_ratio = common.ours;
    else if (all_kinds)
      common.at_least = our_a_ratio;  // the planner and the other variants are not better than ours
    row("tip error, cases solved by all, mean", "m", math::mean(common_tips), common_tips.size());
  }
}

}  // namespace

std::string validation_error(const RepairStudyOptions& o) {
  if (o.variants.empty()) return "variants is empty";
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
  for (const StudyVariant& variant : options.variants)
    variants.push_back(planning::load_config(study.pipeline, variant.set));
  for (const std::uint64_t seed : options.long_seeds) {
    if (run.quick) break;
    std::vector<std::string> set = options.long_search.set;
    set.push_back(fmt::format("seed={}", seed));
    long_searches.push_back(planning::load_config(study.pipeline, set));
  }
  const planning::LoadedConfig planner_only =
      planning::load_config(study.pipeline, options.planner_only.set);

  const int required_cases = run.quick ? options.quick_cases : options.cases;
  std::vector<ObstacleCase> cases;
  int examined = 0;
  parallel::OrderedParallelMap<std::uint64_t, ObstacleCase> map;
  const int end = options.first_recording + options.recordings;
  map.next = [&, next = options.first_recording]() mutable {
    return std::ssize(cases) >= required_cases || next == end
               ? nullptr
               : std::make_unique<std::uint64_t>(static_cast<std::uint64_t>(next++));
  };
  map.work = [&](const std::uint64_t& index) {
    return std::make_unique<ObstacleCase>(
        run_case(study, variants, planner_only, long_searches, index));
  };
  map.write = [&](const ObstacleCase& made) {
    if (std::ssize(cases) >= required_cases) return;  // was started before enough were found
    ++examined;
    if (!made.is_valid) return;
    cases.push_back(made);
    std::string line = fmt::format("{} of {} cases, recording {}, {}:", cases.size(),
                                   required_cases, made.recording, made.kind);
    for (const RepairOutcome& repaired : made.variants) {
      line += repaired.executable
                  ? fmt::format(" A {:.2f}, tips {:.1f} mm;", repaired.humanlikeness_ratio,
                                1e3 * repaired.mean_tip_error_m)
                  : fmt::format(" {};", repaired.failure);
    }
    if (made.found_by_long_search) line += " found by the long search";
    run.progress(line);
  };
  morphe::parallel::run(map, run.jobs);

  StudyResult result;
  result.add({{"obstacle", "all"}}, "recordings examined", "1", examined, cases.size());
  add_rows(options, "all", cases, result);
  for (const char* kind : kObstacleKinds) add_rows(options, kind, cases, result);
  return result;
}

}  // namespace morphe::study
