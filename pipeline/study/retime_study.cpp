#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "core/collision/continuous_check.hpp"
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

constexpr double kDurationFactor = 1.2;  ///< duration of mode duration relative to the fastest
constexpr std::size_t kModes = enum_count<retime::RetimeMode>();
constexpr double kLimitTolerance = 1e-6;  ///< share of a limit, as in the verification

/// The results of one path in the modes.
struct PathOutcome {
  std::array<PlanningFailure, kModes> failure;
  std::array<LimitUsage, kModes> seen;
  std::array<double, kModes> took_s{};
};

PathOutcome score_path(const RandomPath& random) {
  PathOutcome out;
  double fastest_s = 0;
  for (std::size_t mode = 0; mode < kModes; ++mode) {
    retime::RetimeOptions options;
    options.mode = static_cast<retime::RetimeMode>(mode);
    options.sample_rate_hz = random.sample_rate_hz;
    if (options.mode == retime::RetimeMode::duration)
      options.duration_s = std::max(0.05, kDurationFactor * fastest_s);
    Outcome<retime::RetimeResult> result;
    out.took_s[mode] = measure_seconds(
        [&] { result = retime::retime(random.robot, random.path, Movement{}, options); });
    out.failure[mode] = result.failure;
    if (result.failure) continue;
    if (options.mode == retime::RetimeMode::fastest)
      fastest_s = result.value.trajectory.time.back();
    out.seen[mode] = measure_limit_usage(random.robot, result.value.trajectory);
  }
  return out;
}

/// The statistics of all time laws of one mode.
struct TimeLawStatistics {
  std::size_t solved = 0, broken = 0;
  LimitUsage worst{0, 0, 0, -std::numeric_limits<double>::infinity(), true, true};
  std::vector<double> took_s;

  void add(const PlanningFailure& failure, const LimitUsage& seen, double took) {
    took_s.push_back(took);
    if (failure) return;
    ++solved;
    const double most = std::max({seen.velocity, seen.acceleration, seen.jerk});
    const bool good = most <= 1 + kLimitTolerance && seen.position_excess <= 0 && seen.at_rest &&
                      seen.time_increases;
    broken += good ? 0 : 1;
    worst.velocity = std::max(worst.velocity, seen.velocity);
    worst.acceleration = std::max(worst.acceleration, seen.acceleration);
    worst.jerk = std::max(worst.jerk, seen.jerk);
    worst.position_excess = std::max(worst.position_excess, seen.position_excess);
    worst.at_rest = worst.at_rest && seen.at_rest;
    worst.time_increases = worst.time_increases && seen.time_increases;
  }
};

void add_law_rows(const TimeLawStatistics& laws, const Case& of, StudyResult& result) {
  const std::size_t all = laws.took_s.size();
  const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
    result.rows.push_back(make_row(of, metric, unit, value, all));
    return result.rows.back();
  };
  row("solved", "1", static_cast<double>(laws.solved) / static_cast<double>(all)).at_least = 1;
  row("time laws beyond a limit", "1", static_cast<double>(laws.broken)).at_most = 0;
  row("largest velocity over its limit", "1", laws.worst.velocity).at_most = 1.001;
  row("largest acceleration over its limit", "1", laws.worst.acceleration).at_most = 1.001;
  row("largest jerk over its limit", "1", laws.worst.jerk).at_most = 1.01;
  row("largest excess over a position limit", "rad", laws.worst.position_excess).at_most = 0;
  row("at rest at both ends", "1", laws.worst.at_rest).at_least = 1;
  row("time always increases", "1", laws.worst.time_increases).at_least = 1;
  row("time per path, median", "s", math::quantile(laws.took_s, 0.5)).is_timing = true;
  row("time per path, 99th percentile", "s", math::quantile(laws.took_s, 0.99)).is_timing = true;
}

void score_random_paths(const char* paths, int count, const StudyRun& study,
                        const std::function<RandomPath(std::uint64_t)>& path, StudyResult& result) {
  std::array<TimeLawStatistics, kModes> laws;
  std::size_t done = 0;
  const std::size_t step = count > 20000 ? 10000 : 200;
  parallel::ordered_for_each<PathOutcome>(
      count, study.jobs, [&](std::uint64_t index) { return score_path(path(index)); },
      [&](const PathOutcome& outcome) {
        for (std::size_t mode = 0; mode < kModes; ++mode) {
          laws[mode].add(outcome.failure[mode], outcome.seen[mode], outcome.took_s[mode]);
          if (outcome.failure[mode])
            study.progress(fmt::format("{} path {}, mode {}: {}, {}", paths, done,
                                       name_of(static_cast<retime::RetimeMode>(mode)),
                                       name_of(outcome.failure[mode].reason),
                                       outcome.failure[mode].detail));
        }
        if (++done % step == 0) study.progress(fmt::format("{} paths, {}", done, paths));
      });
  for (std::size_t mode = 0; mode < kModes; ++mode)
    add_law_rows(
        laws[mode],
        {{"paths", paths}, {"mode", std::string(name_of(static_cast<retime::RetimeMode>(mode)))}},
        result);
}

void score_all_random_paths(const RetimeStudyOptions& options, const StudyRun& study,
                            StudyResult& result) {
  score_random_paths(
      "random", study.quick ? options.quick_paths : options.paths, study,
      [&](std::uint64_t index) { return random_path(options.seed, index); }, result);
  score_random_paths(
      "small", study.quick ? options.quick_short_paths : options.short_paths, study,
      [&](std::uint64_t index) { return short_path(options.seed, index); }, result);
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
        path.robot.jerk.setConstant(std::numeric_limits<double>::infinity());
        const Movement movement;
        const retime::ConstrainedPath course =
            paced_path_without_jerk(path.robot, path.path, movement);
        const double least_s = reference_least_time_s(course, kReferenceSteps);
        retime::RetimeOptions fastest;
        fastest.mode = retime::RetimeMode::fastest;
        return Ratios{
            retime::fastest_law(course).duration_s / least_s,
            retime::retime(path.robot, path.path, movement, fastest).value.trajectory.time.back() /
                least_s};
      },
      [&](const Ratios& ratios) {
        law.push_back(ratios.law);
        sampled.push_back(ratios.sampled);
      });
  const Case of = {{"paths", "smooth, no jerk limit"}, {"mode", "fastest"}};
  const auto row = [&](const char* metric, const std::vector<double>& values, double at_most) {
    result.rows.push_back(make_row(of, fmt::format("{}, largest", metric), "1",
                                   math::quantile(values, 1), values.size()));
    result.rows.back().at_most = at_most;
    result.rows.push_back(
        make_row(of, fmt::format("{}, mean", metric), "1", math::mean(values), values.size()));
  };
  row("duration over the shortest possible", law, 1.005);
  result.rows.push_back(make_row(of, "duration over the shortest possible, smallest", "1",
                                 math::quantile(law, 0), law.size()));
  result.rows.back().at_least = 0.995;
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
        const Case of = {{"trial", demonstration.name}, {"limits", robot}};
        result.rows.push_back(make_row(of, metric, "1", value, 1));
        return result.rows.back();
      };
      const TimingScore real = score_timing(config.robot, plan.goals, plan.trajectory);
      row("the robot's", "tempo", real.duration_ratio);
      row("the robot's", "share of time at the human's speed", real.human_speed_share);
      const Outcome<retime::RetimeResult> free =
          retime::retime(stronger, plan.path, plan.movement, config.options.retime);
      const TimingScore timing = score_timing(config.robot, plan.goals, free.value.trajectory);
      StudyRow& tempo = row("stronger", "tempo", timing.duration_ratio);
      tempo.at_least = 0.9995;
      tempo.at_most = 1.0005;
      row("stronger", "share of time at the human's speed", timing.human_speed_share);
      row("stronger", "tip speeds, correlation with the human's", timing.correlation).at_least =
          0.999;
    }
    study.progress(demonstration.name);
  });
}

}  // namespace

std::string validation_error(const RetimeStudyOptions& o) {
  if (std::min({o.paths, o.quick_paths, o.short_paths, o.quick_short_paths, o.optimum_paths,
                o.quick_optimum_paths}) < 1) {
    return "numbers of paths must be positive";
  }
  if (o.pipeline.empty() != o.manifest.empty())
    return "pipeline and manifest must be given together";
  if (!(o.limit_factor >= 1)) return "limit_factor must be at least 1";
  return "";
}

StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run) {
  RetimeStudyOptions options;
  config::read_document(config, options);
  StudyResult result;
  score_all_random_paths(options, run, result);
  add_optimum_rows(options, run, result);
  if (!options.pipeline.empty()) add_trial_rows(options, run, result);
  return result;
}

}  // namespace morphe::study
