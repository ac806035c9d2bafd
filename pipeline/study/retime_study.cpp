#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "core/math/statistics.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/retime_options.hpp"
#include "pipeline/study/retime_paths.hpp"
#include "pipeline/study/retime_reference.hpp"
#include "pipeline/study/score_timing.hpp"
#include "pipeline/study/study.hpp"
#include "stages/import/import.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::study {
namespace {

constexpr double kDurationFactor = 1.2;  ///< of mode duration relative to the fastest
constexpr std::size_t kModes = enum_count<retime::RetimeMode>();
constexpr double kLimitTolerance = 1e-6;  ///< share of a limit, as in the verification

struct ModeOutcome {
  PlanningFailure failure;
  LimitUsage usage;
  double duration_s = 0;  ///< time that the computation takes
};
using PathOutcome = std::array<ModeOutcome, kModes>;

PathOutcome score_path(const RandomPath& random) {
  PathOutcome outcomes;
  double fastest_s = 0;
  for (int mode = 0; mode < std::ssize(outcomes); ++mode) {
    ModeOutcome& outcome = outcomes[mode];
    retime::RetimeOptions options;
    options.mode = static_cast<retime::RetimeMode>(mode);
    options.sample_rate_hz = random.sample_rate_hz;
    if (options.mode == retime::RetimeMode::duration)
      options.duration_s = std::max(0.05, kDurationFactor * fastest_s);
    Outcome<retime::RetimeResult> result;
    outcome.duration_s = measure_seconds(
        [&] { result = retime::retime(random.robot, random.path, Movement{}, options); });
    outcome.failure = result.failure;
    if (result.failure) continue;
    if (options.mode == retime::RetimeMode::fastest)
      fastest_s = result.value.trajectory.time.back();
    outcome.usage = measure_limit_usage(random.robot, result.value.trajectory);
  }
  return outcomes;
}

struct TimeLawStatistics {
  int solved = 0, violating = 0;
  LimitUsage worst{0, 0, 0, -kInfinity, true, true};
  std::vector<double> durations_s;

  void add(const ModeOutcome& outcome) {
    durations_s.push_back(outcome.duration_s);
    if (outcome.failure) return;
    ++solved;
    const LimitUsage& usage = outcome.usage;
    const double max_usage = std::max({usage.velocity, usage.acceleration, usage.jerk});
    const bool valid = max_usage <= 1 + kLimitTolerance && usage.position_excess <= 0 &&
                       usage.at_rest && usage.time_increases;
    violating += valid ? 0 : 1;
    worst.velocity = std::max(worst.velocity, usage.velocity);
    worst.acceleration = std::max(worst.acceleration, usage.acceleration);
    worst.jerk = std::max(worst.jerk, usage.jerk);
    worst.position_excess = std::max(worst.position_excess, usage.position_excess);
    worst.at_rest = worst.at_rest && usage.at_rest;
    worst.time_increases = worst.time_increases && usage.time_increases;
  }
};

void add_law_rows(const TimeLawStatistics& laws, const Case& condition, StudyResult& result) {
  const std::ptrdiff_t all = std::ssize(laws.durations_s);
  const auto row = [&](auto... values) -> StudyRow& {
    return result.add(condition, values..., all);
  };
  row("solved", "1", laws.solved / static_cast<double>(all)).at_least = 1;
  row("time laws beyond a limit", "1", laws.violating).at_most = 0;
  row("largest velocity over its limit", "1", laws.worst.velocity).at_most = 1.001;
  row("largest acceleration over its limit", "1", laws.worst.acceleration).at_most = 1.001;
  row("largest jerk over its limit", "1", laws.worst.jerk).at_most = 1.01;
  row("largest excess over a position limit", "rad", laws.worst.position_excess).at_most = 0;
  row("at rest at both ends", "1", laws.worst.at_rest).at_least = 1;
  row("time always increases", "1", laws.worst.time_increases).at_least = 1;
  row("time per path, median", "s", math::quantile(laws.durations_s, 0.5)).is_timing = true;
  row("time per path, 99th percentile", "s", math::quantile(laws.durations_s, 0.99)).is_timing =
      true;
}

void score_random_paths(const char* paths, int count, const StudyRun& study,
                        const std::function<RandomPath(std::uint64_t)>& path, StudyResult& result) {
  std::array<TimeLawStatistics, kModes> laws;
  int scored = 0;
  const int every = count > 20000 ? 10000 : 200;
  const auto mode_name = [](int mode) {
    return std::string(name_of(static_cast<retime::RetimeMode>(mode)));
  };
  parallel::ordered_for_each<PathOutcome>(
      count, study.jobs, [&](std::uint64_t index) { return score_path(path(index)); },
      [&](const PathOutcome& outcomes) {
        for (int mode = 0; mode < std::ssize(laws); ++mode) {
          laws[mode].add(outcomes[mode]);
          if (const PlanningFailure& failure = outcomes[mode].failure)
            study.progress(fmt::format("{} path {}, mode {}: {}, {}", paths, scored,
                                       mode_name(mode), name_of(failure.reason), failure.detail));
        }
        if (++scored % every == 0) study.progress(fmt::format("{} paths, {}", scored, paths));
      });
  for (int mode = 0; mode < std::ssize(laws); ++mode)
    add_law_rows(laws[mode], {{"paths", paths}, {"mode", mode_name(mode)}}, result);
}

void add_optimum_rows(const RetimeStudyOptions& options, const StudyRun& study,
                      StudyResult& result) {
  constexpr int kReferenceSteps = 20000;
  struct Ratios {
    double law = 0, sampled = 0;
  };
  std::vector<double> law, sampled;
  parallel::ordered_for_each<Ratios>(
      study.quick ? options.quick_optimum_paths : options.optimum_paths, study.jobs,
      [&](std::uint64_t index) {
        RandomPath path =
            smooth_path(options.seed, index, 1 + static_cast<int>(index * 7 % 30), 200, 2);
        path.robot.jerk.setConstant(kInfinity);
        const Movement movement;
        const retime::ConstrainedPath constrained =
            paced_path_without_jerk(path.robot, path.path, movement);
        const double least_s = reference_least_time_s(constrained, kReferenceSteps);
        retime::RetimeOptions fastest;
        fastest.mode = retime::RetimeMode::fastest;
        const retime::RetimeResult retimed =
            retime::retime(path.robot, path.path, movement, fastest).value;
        return Ratios{retime::fastest_law(constrained).duration_s / least_s,
                      retimed.trajectory.time.back() / least_s};
      },
      [&](const Ratios& ratios) {
        law.push_back(ratios.law);
        sampled.push_back(ratios.sampled);
      });
  const Case condition = {{"paths", "smooth, no jerk limit"}, {"mode", "fastest"}};
  const auto row = [&](const char* metric, const std::vector<double>& values, double at_most) {
    result
        .add(condition, fmt::format("{}, largest", metric), "1", math::quantile(values, 1),
             values.size())
        .at_most = at_most;
    result.add(condition, fmt::format("{}, mean", metric), "1", math::mean(values), values.size());
  };
  row("duration over the shortest possible", law, 1.005);
  result
      .add(condition, "duration over the shortest possible, smallest", "1", math::quantile(law, 0),
           law.size())
      .at_least = 0.995;
  row("sampled duration over the shortest possible", sampled, 1.02);
}

void add_trial_rows(const RetimeStudyOptions& options, const StudyRun& study, StudyResult& result) {
  const std::filesystem::path folder = study.config.parent_path();
  const planning::LoadedConfig config = planning::load_config(folder / options.pipeline);
  const planning::PlanningInputs planner{config.options, config.robot};
  robot::Robot stronger = config.robot;
  stronger.velocity *= options.limit_factor;
  stronger.acceleration *= options.limit_factor;
  stronger.jerk *= options.limit_factor;
  imports::ImportRequest request;
  request.paths = {folder / options.manifest};
  int recordings = 0;
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    if (recordings++ >= (study.quick ? options.quick_trials : options.trials)) return;
    for (const Plan& plan : planning::plan_demonstration(planner, demonstration).plans) {
      if (!plan.has_trajectory()) continue;
      const auto row = [&](const char* robot, const char* metric, double value) -> StudyRow& {
        return result.add({{"trial", demonstration.name}, {"limits", robot}}, metric, "1", value,
                          1);
      };
      const TimingScore real = score_timing(config.robot, plan.goals, plan.trajectory);
      row("the robot's", "duration ratio", real.duration_ratio);
      row("the robot's", "share of time at the human's speed", real.human_speed_share);
      const Outcome<retime::RetimeResult> unlimited =
          retime::retime(stronger, plan.path, plan.movement, config.options.retime);
      const TimingScore timing = score_timing(config.robot, plan.goals, unlimited.value.trajectory);
      StudyRow& duration_ratio = row("stronger", "duration ratio", timing.duration_ratio);
      duration_ratio.at_least = 0.9995;
      duration_ratio.at_most = 1.0005;
      row("stronger", "share of time at the human's speed", timing.human_speed_share);
      row("stronger", "tip speeds, correlation with the human's", timing.correlation).at_least =
          0.999;
    }
    study.progress(demonstration.name);
  });
}

}  // namespace

std::string validation_error(const RetimeStudyOptions& o) {
  if (o.pipeline.empty() != o.manifest.empty())
    return "pipeline and manifest must be given together";
  return "";
}

StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run) {
  RetimeStudyOptions options;
  config::read_document(config, options);
  StudyResult result;
  score_random_paths(
      "random", run.quick ? options.quick_paths : options.paths, run,
      [&](std::uint64_t index) { return random_path(options.seed, index); }, result);
  score_random_paths(
      "small", run.quick ? options.quick_short_paths : options.short_paths, run,
      [&](std::uint64_t index) { return short_path(options.seed, index); }, result);
  add_optimum_rows(options, run, result);
  if (!options.pipeline.empty()) add_trial_rows(options, run, result);
  return result;
}

}  // namespace morphe::study
