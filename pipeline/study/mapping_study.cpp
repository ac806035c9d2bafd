#include <fmt/format.h>

#include <algorithm>

#include "core/math/statistics.hpp"
#include "pipeline/study/mapping_options.hpp"
#include "pipeline/study/plan_recordings.hpp"
#include "pipeline/study/results.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {
namespace {

struct VariantResult {
  std::string name;
  std::vector<Plan> plans;
  double map_s = 0;
  double tip_position = 0;  ///< weight w_x of its objective
};

VariantResult plan_all(const MappingSet& set, const StudyVariant& variant,
                       const std::vector<Demonstration>& recordings, const StudyRun& run) {
  const planning::LoadedConfig config =
      planning::load_config(run.config.parent_path() / set.pipeline, variant.set);
  PlannedRecordings planned = plan_recordings(config, recordings, run.jobs);
  return {variant.name, std::move(planned.plans), planned.map_s,
          config.options.map.objective.get<humanlike::TipPosition>().weight};
}

double objective_sum(const Plan& plan) {
  double sum = 0;
  for (const double value : plan.mapped.objective) sum += value;
  return sum;
}

/// Appends the finite values of a column.
void append_finite(const JointRows& rows, std::vector<double>& values) {
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    if (std::isfinite(rows.data()[i])) values.push_back(rows.data()[i]);
  }
}

struct MappingFigures {
  int movements = 0, executable = 0, jumps = 0, frames = 0, excess = 0, reachable = 0, goals = 0;
  std::vector<double> tips, a, b, c, upper_arm;
};

/// Returns F of a frame, after adding `weight_change` to the weight of the tip positions.
double objective_with_weight(const MappingResult& mapped, int frame, double weight_change) {
  double squares = 0;
  for (const double error : mapped.tip_error.row(frame)) {
    if (std::isfinite(error)) squares += error * error;
  }
  return mapped.objective[frame] + weight_change * squares;
}

MappingFigures figures_of(const MappingStudyOptions& options, const VariantResult& variant,
                          const std::vector<const Plan*>& best) {
  const double weight_change = options.tip_position - variant.tip_position;
  MappingFigures figures;
  for (int k = 0; k < std::ssize(variant.plans); ++k) {
    const Plan& plan = variant.plans[k];
    ++figures.movements;
    figures.executable += plan.executable() ? 1 : 0;
    for (const Finding& finding : plan.findings)
      figures.jumps += finding.cause == Cause::jump ? 1 : 0;
    const MappingResult& mapped = plan.mapped;
    for (int f = 0; f < std::ssize(mapped.objective); ++f) {
      ++figures.frames;
      const double objective = objective_with_weight(mapped, f, weight_change),
                   best_objective = objective_with_weight(best[k]->mapped, f, weight_change);
      figures.excess += objective > best_objective + options.excess_threshold ? 1 : 0;
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
    if (std::isfinite(plan.certificate.upper_arm_error_mean))
      figures.upper_arm.push_back(plan.certificate.upper_arm_error_mean);
  }
  return figures;
}

void add_rows(const MappingStudyOptions& options, const MappingSet& set,
              const std::vector<VariantResult>& variants, bool all_recordings,
              StudyResult& result) {
  // The best known sequence of each movement is that of options.reference_variant, if the sum of
  // its objective over the frames is smaller, otherwise ours.
  std::vector<const Plan*> best;
  for (int k = 0; k < std::ssize(variants.front().plans); ++k) {
    const Plan* best_plan = &variants.front().plans[k];
    for (const VariantResult& variant : variants) {
      const Plan& plan = variant.plans[k];
      if (variant.name != options.reference_variant || plan.mapped.objective.empty()) continue;
      if (objective_sum(plan) < objective_sum(*best_plan)) best_plan = &plan;
    }
    best.push_back(best_plan);
  }
  double ik_a = kUnknown, ik_tips = kUnknown, our_tips = kUnknown;
  for (const VariantResult& variant : variants) {
    const MappingFigures figures = figures_of(options, variant, best);
    const Case condition = {{"set", set.name}, {"variant", variant.name}};
    const auto share = [](double part, int whole) { return part / whole; };
    const auto row = [&](const char* metric, const char* unit, double value,
                         std::ptrdiff_t n) -> StudyRow& {
      StudyRow& added = result.add(condition, metric, unit, value, n);
      added.reachable = share(figures.reachable, figures.goals);
      return added;
    };
    const bool ours = &variant == &variants.front();
    row("executable", "1", share(figures.executable, figures.movements), figures.movements);
    // Without humanlikeness, the objective is another one and cannot be compared.
    if (!options.reference_variant.empty() && variant.name != options.ik_variant)
      row("frames worse than the best sequence", "1", share(figures.excess, figures.frames),
          figures.frames)
          .at_most = ours ? 0.02 : kUnknown;
    row("jumps", "1", figures.jumps, figures.movements).at_most = ours ? 0 : kUnknown;
    const double tips = math::quantile(figures.tips, 0.5);
    row("tip error, reachable goals, median", "m", tips, figures.tips.size());
    if (ours) our_tips = tips;
    row("tip error, reachable goals, 99th percentile", "m", math::quantile(figures.tips, 0.99),
        figures.tips.size());
    row("A, sum over centres", "m^2", math::mean(figures.a), figures.a.size());
    row("B", "m^2", math::mean(figures.b), figures.b.size());
    row("C", "m^3", math::mean(figures.c), figures.c.size());
    row("upper arm angle to the human's", "rad", math::mean(figures.upper_arm),
        figures.upper_arm.size());
    row("mapping time per frame", "s", variant.map_s / figures.frames, figures.frames).is_timing =
        true;
    if (variant.name == options.ik_variant) {
      ik_a = math::mean(figures.a);
      ik_tips = tips;
    }
  }
  if (options.ik_variant.empty()) return;
  const Case condition = {{"set", set.name},
                          {"variant", variants.front().name + " over " + options.ik_variant}};
  const MappingFigures figures = figures_of(options, variants.front(), best);
  StudyRow& ratio =
      result.add(condition, "A, ratio", "1", math::mean(figures.a) / ik_a, figures.a.size());
  // Required for real recordings, over all of a set.
  if (all_recordings && set.recordings.synthetic.empty()) ratio.at_most = 0.7;
  result
      .add(condition, "tip error, median, difference", "m", our_tips - ik_tips, figures.tips.size())
      .at_most = 0.05e-3;
}

}  // namespace

std::string validation_error(const MappingSet& set) { return validation_error(set.recordings); }

std::string validation_error(const MappingStudyOptions& o) {
  if (o.sets.empty()) return "sets is empty";
  if (o.variants.empty()) return "variants is empty";
  for (const std::string& name : {o.reference_variant, o.ik_variant}) {
    if (!name.empty() && std::ranges::count(o.variants, name, &StudyVariant::name) == 0)
      return fmt::format("unknown variant '{}'", name);
  }
  return "";
}

StudyResult mapping_study(const config::ConfigNode& config, const StudyRun& run) {
  MappingStudyOptions options;
  config::read_document(config, options);
  StudyResult result;
  for (const MappingSet& set : options.sets) {
    const std::vector<Demonstration> recordings = load_recordings(set.recordings, run);
    std::vector<VariantResult> variants;
    for (const StudyVariant& variant : options.variants) {
      variants.push_back(plan_all(set, variant, recordings, run));
      run.progress(fmt::format("{}, {}: {} movements", set.name, variant.name,
                               variants.back().plans.size()));
    }
    StudyResult set_result;  // reports intermediate results, because the study takes hours
    add_rows(options, set, variants, !run.quick, set_result);
    run.progress(results_table(set_result));
    std::ranges::move(set_result.rows, std::back_inserter(result.rows));
  }
  return result;
}

}  // namespace morphe::study
