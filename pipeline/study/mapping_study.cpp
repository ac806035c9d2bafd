#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/collision/continuous_check.hpp"
#include "core/math/statistics.hpp"
#include "core/store/demonstration_file.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/mapping_options.hpp"
#include "pipeline/study/results.hpp"
#include "pipeline/study/study.hpp"
#include "pipeline/synthesize/synthesize.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

/// The results of a variant on a set.
struct VariantResult {
  std::string name;
  std::vector<Plan> plans;
  double map_s = 0;
  double tip_position = 0;  ///< weight w_x of its objective
};

std::vector<Demonstration> recordings_of(const MappingSet& set, const StudyRun& run) {
  const std::filesystem::path folder = run.config.parent_path();
  const auto count = static_cast<std::size_t>(run.quick ? set.quick_count : set.count);
  std::vector<Demonstration> all;
  if (set.synthetic.empty()) {
    imports::ImportRequest request;
    request.paths = {folder / set.manifest};
    imports::import_recordings(request, [&](Demonstration&& d) {
      if (all.size() < count) all.push_back(std::move(d));
    });
    return all;
  }
  synthesize::SynthesizeOptions synthetic;
  const config::ConfigNode node = config::ConfigNode::load(folder / set.synthetic);
  config::read_document(node, synthetic);
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(synthesize::synthesize(synthetic, set.seed, i).recorded);
  }
  return all;
}

VariantResult plan_all(const MappingSet& set, const StudyVariant& variant,
                       const std::vector<Demonstration>& recordings, const StudyRun& run) {
  const planning::LoadedConfig config =
      planning::load_config(run.config.parent_path() / set.pipeline, variant.set);
  const planning::PlanningInputs planner{config.options, config.robot};
  VariantResult result;
  result.name = variant.name;
  result.tip_position = config.options.map.objective.get<humanlike::TipPosition>().weight;
  run::Batch batch;
  batch.next = [&, next = std::size_t{0}]() mutable {
    return next == recordings.size() ? nullptr
                                     : std::make_unique<Demonstration>(recordings[next++]);
  };
  batch.plan = [&](const Demonstration& d) { return planning::plan_demonstration(planner, d); };
  batch.write = [&](const run::DemonstrationOutcome& outcome) {
    result.plans.insert(result.plans.end(), outcome.plans.begin(), outcome.plans.end());
  };
  result.map_s = run::run_batch(batch, run.jobs).stage_cpu_s["map"];
  return result;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

/// Appends all finite values of a plan's column.
void append_finite(const JointRows& rows, std::vector<double>& values) {
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    if (std::isfinite(rows.data()[i])) values.push_back(rows.data()[i]);
  }
}

struct MappingFigures {
  std::size_t movements = 0, executable = 0, jumps = 0, frames = 0, excess = 0, reachable = 0,
              goals = 0;
  std::vector<double> tips, a, b, c, upper_arm;
};

/// Computes F of a frame with another weight of the tip positions than in its mapping.
double objective_with_weight(const MappingResult& mapped, std::size_t frame,
                             double change_of_weight) {
  double squares = 0;
  for (const double error : mapped.tip_error.row(frame)) {
    if (std::isfinite(error)) squares += error * error;
  }
  return mapped.objective[frame] + change_of_weight * squares;
}

MappingFigures figures_of(const MappingStudyOptions& options, const VariantResult& variant,
                          const std::vector<const Plan*>& best) {
  const double change = options.tip_position - variant.tip_position;
  MappingFigures figures;
  for (std::size_t k = 0; k < variant.plans.size(); ++k) {
    const Plan& plan = variant.plans[k];
    ++figures.movements;
    figures.executable += plan.executable() ? 1 : 0;
    for (const Finding& finding : plan.findings)
      figures.jumps += finding.cause == Cause::jump ? 1 : 0;
    const MappingResult& mapped = plan.mapped;
    for (std::size_t f = 0; f < mapped.objective.size(); ++f) {
      ++figures.frames;
      const double known = objective_with_weight(best[k]->mapped, f, change);
      figures.excess +=
          objective_with_weight(mapped, f, change) > known + options.excess_threshold ? 1 : 0;
      for (std::size_t tip = 0; tip < plan.goals.tip_position.cols; ++tip) {
        if (!is_known(plan.goals.tip_position(f, tip))) continue;
        ++figures.goals;
        if (!best[k]->goals.reachable(f, tip)) continue;
        ++figures.reachable;
        figures.tips.push_back(mapped.tip_error(f, tip));
      }
    }
    if (mapped.objective.empty()) continue;
    append_finite(mapped.humanlikeness.col(0), figures.a);
    append_finite(mapped.humanlikeness.col(1), figures.b);
    append_finite(mapped.humanlikeness.col(2), figures.c);
    if (std::isfinite(plan.certificate.upper_arm_error_mean)) {
      figures.upper_arm.push_back(plan.certificate.upper_arm_error_mean);
    }
  }
  return figures;
}

void add_rows(const MappingStudyOptions& options, const MappingSet& set,
              const std::vector<VariantResult>& variants, bool all_recordings,
              StudyResult& result) {
  // The best known sequence of each movement is that of the variant `best` if the sum of its
  // objective is smaller, otherwise ours.
  std::vector<const Plan*> best;
  for (std::size_t k = 0; k < variants.front().plans.size(); ++k) {
    const Plan* least = &variants.front().plans[k];
    for (const VariantResult& variant : variants) {
      const Plan& plan = variant.plans[k];
      if (variant.name != options.reference_variant || plan.mapped.objective.empty()) continue;
      if (sum(plan.mapped.objective) < sum(least->mapped.objective)) least = &plan;
    }
    best.push_back(least);
  }
  double without_a = kUnknown, without_tips = kUnknown;
  std::size_t ours = 0;
  for (const VariantResult& variant : variants) {
    const MappingFigures figures = figures_of(options, variant, best);
    const Case of = {{"set", set.name}, {"variant", variant.name}};
    const auto row = [&](const char* metric, const char* unit, double value,
                         std::size_t n) -> StudyRow& {
      result.rows.push_back(make_row(of, metric, unit, value, n));
      result.rows.back().reachable =
          static_cast<double>(figures.reachable) / static_cast<double>(figures.goals);
      return result.rows.back();
    };
    const auto share = [](std::size_t part, std::size_t whole) {
      return static_cast<double>(part) / static_cast<double>(whole);
    };
    const bool first = &variant == &variants.front();
    row("executable", "1", share(figures.executable, figures.movements), figures.movements);
    if (!options.reference_variant.empty() &&
        variant.name != options.ik_variant) {  // the objective differs
      StudyRow& excess = row("frames worse than the best sequence", "1",
                             share(figures.excess, figures.frames), figures.frames);
      if (first) excess.at_most = 0.02;
    }
    StudyRow& jumps = row("jumps", "1", static_cast<double>(figures.jumps), figures.movements);
    if (first) jumps.at_most = 0;
    row("tip error, reachable goals, median", "m", math::quantile(figures.tips, 0.5),
        figures.tips.size());
    if (first) ours = result.rows.size() - 1;
    row("tip error, reachable goals, 99th percentile", "m", math::quantile(figures.tips, 0.99),
        figures.tips.size());
    row("A, sum over centres", "m^2", math::mean(figures.a), figures.a.size());
    row("B", "m^2", math::mean(figures.b), figures.b.size());
    row("C", "m^3", math::mean(figures.c), figures.c.size());
    row("upper arm angle to the human's", "rad", math::mean(figures.upper_arm),
        figures.upper_arm.size());
    StudyRow& time = row("mapping time per frame", "s",
                         variant.map_s / static_cast<double>(figures.frames), figures.frames);
    time.is_timing = true;
    if (variant.name == options.ik_variant) {
      without_a = math::mean(figures.a);
      without_tips = math::quantile(figures.tips, 0.5);
    }
  }
  if (options.ik_variant.empty()) return;
  const Case of = {{"set", set.name},
                   {"variant", variants.front().name + " over " + options.ik_variant}};
  const MappingFigures figures = figures_of(options, variants.front(), best);
  result.rows.push_back(
      make_row(of, "A, ratio", "1", math::mean(figures.a) / without_a, figures.a.size()));
  // This value is guaranteed for real recordings, all of them together.
  if (all_recordings && set.synthetic.empty()) result.rows.back().at_most = 0.7;
  result.rows.push_back(make_row(of, "tip error, median, difference", "m",
                                 result.rows[ours].ours - without_tips, figures.tips.size()));
  result.rows.back().at_most = 0.05e-3;
}

}  // namespace

std::string validation_error(const MappingSet& o) {
  if (o.manifest.empty() == o.synthetic.empty()) return "needs `manifest` or `synthetic`";
  if (o.count < 1 || o.quick_count < 1) return "count and quick_count must be positive";
  return "";
}

std::string validation_error(const MappingStudyOptions& o) {
  if (o.sets.empty()) return "sets is empty";
  if (o.variants.empty()) return "variants is empty";
  for (const std::string& name : {o.reference_variant, o.ik_variant}) {
    if (!name.empty() && std::ranges::none_of(o.variants, [&](const StudyVariant& variant) {
          return variant.name == name;
        })) {
      return fmt::format("unknown variant '{}'", name);
    }
  }
  return "";
}

StudyResult mapping_study(const config::ConfigNode& config, const StudyRun& run) {
  MappingStudyOptions options;
  config::read_document(config, options);
  StudyResult result;
  for (const MappingSet& set : options.sets) {
    const std::vector<Demonstration> recordings = recordings_of(set, run);
    std::vector<VariantResult> variants;
    for (const StudyVariant& variant : options.variants) {
      variants.push_back(plan_all(set, variant, recordings, run));
      run.progress(fmt::format("{}, {}: {} movements", set.name, variant.name,
                               variants.back().plans.size()));
    }
    StudyResult of_set;  // reports intermediate results, because the study takes hours
    add_rows(options, set, variants, !run.quick, of_set);
    run.progress(results_table(of_set));
    result.rows.insert(result.rows.end(), of_set.rows.begin(), of_set.rows.end());
  }
  return result;
}

}  // namespace morphe::study
