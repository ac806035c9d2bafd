#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "core/collision/certified.hpp"
#include "core/math/statistics.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/human_tempo.hpp"
#include "pipeline/study/retime_options.hpp"
#include "pipeline/study/retime_paths.hpp"
#include "pipeline/study/retime_reference.hpp"
#include "pipeline/study/stopwatch.hpp"
#include "pipeline/study/study.hpp"
#include "stages/import/import.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe::study {
namespace {

constexpr double kSpare = 1.2;  ///< mode duration: times the fastest
constexpr std::size_t kModes = count_of<retime::Tempo>();
constexpr double kTolerance = 1e-6;  ///< of a limit, as verify has it

/// What became of one path in the modes.
struct PathOutcome {
  std::array<Refusal, kModes> refusal;
  std::array<SeenLimits, kModes> seen;
  std::array<double, kModes> took_s{};
};

PathOutcome score_path(const RandomPath& random) {
  PathOutcome out;
  double fastest_s = 0;
  for (std::size_t mode = 0; mode < kModes; ++mode) {
    retime::RetimeOptions options;
    options.mode = static_cast<retime::Tempo>(mode);
    options.sample_rate_hz = random.sample_rate_hz;
    if (options.mode == retime::Tempo::duration)
      options.duration_s = std::max(0.05, kSpare * fastest_s);
    Outcome<retime::RetimeResult> result;
    out.took_s[mode] =
        seconds([&] { result = retime::retime(random.robot, random.path, Movement{}, options); });
    out.refusal[mode] = result.refusal;
    if (result.refusal) continue;
    if (options.mode == retime::Tempo::fastest) fastest_s = result.value.trajectory.time.back();
    out.seen[mode] = seen_limits(random.robot, result.value.trajectory);
  }
  return out;
}

/// All laws of one mode.
struct Laws {
  std::size_t solved = 0, broken = 0;
  SeenLimits worst{0, 0, 0, -std::numeric_limits<double>::infinity(), true, true};
  std::vector<double> took_s;

  void add(const Refusal& refusal, const SeenLimits& seen, double took) {
    took_s.push_back(took);
    if (refusal) return;
    ++solved;
    const double most = std::max({seen.velocity, seen.acceleration, seen.jerk});
    const bool good =
        most <= 1 + kTolerance && seen.beyond <= 0 && seen.at_rest && seen.time_increases;
    broken += good ? 0 : 1;
    worst.velocity = std::max(worst.velocity, seen.velocity);
    worst.acceleration = std::max(worst.acceleration, seen.acceleration);
    worst.jerk = std::max(worst.jerk, seen.jerk);
    worst.beyond = std::max(worst.beyond, seen.beyond);
    worst.at_rest = worst.at_rest && seen.at_rest;
    worst.time_increases = worst.time_increases && seen.time_increases;
  }
};

void tell(const Laws& laws, const Case& of, StudyResult& result) {
  const std::size_t all = laws.took_s.size();
  const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
    result.rows.push_back(row_of(of, metric, unit, value, all));
    return result.rows.back();
  };
  row("solved", "1", static_cast<double>(laws.solved) / static_cast<double>(all)).at_least = 1;
  row("laws that break a limit", "1", static_cast<double>(laws.broken)).at_most = 0;
  row("largest velocity over its limit", "1", laws.worst.velocity).at_most = 1.001;
  row("largest acceleration over its limit", "1", laws.worst.acceleration).at_most = 1.001;
  row("largest jerk over its limit", "1", laws.worst.jerk).at_most = 1.01;
  row("farthest beyond a position limit", "rad", laws.worst.beyond).at_most = 0;
  row("all at rest at both ends", "1", laws.worst.at_rest).at_least = 1;
  row("time always increases", "1", laws.worst.time_increases).at_least = 1;
  row("time of one, median", "s", math::quantile(laws.took_s, 0.5)).timed = true;
  row("time of one, 99th percentile", "s", math::quantile(laws.took_s, 0.99)).timed = true;
}

void random_laws(const char* paths, int count, const StudyRun& study,
                 const std::function<RandomPath(std::uint64_t)>& path, StudyResult& result) {
  std::array<Laws, kModes> laws;
  std::size_t done = 0;
  const std::size_t step = count > 20000 ? 10000 : 200;
  parallel::for_each<PathOutcome>(
      count, study.jobs, [&](std::uint64_t index) { return score_path(path(index)); },
      [&](const PathOutcome& outcome) {
        for (std::size_t mode = 0; mode < kModes; ++mode) {
          laws[mode].add(outcome.refusal[mode], outcome.seen[mode], outcome.took_s[mode]);
          if (outcome.refusal[mode])
            study.progress(fmt::format("{} path {}, mode {}: {}, {}", paths, done,
                                       name_of(static_cast<retime::Tempo>(mode)),
                                       name_of(outcome.refusal[mode].reason),
                                       outcome.refusal[mode].detail));
        }
        if (++done % step == 0) study.progress(fmt::format("{} paths, {}", done, paths));
      });
  for (std::size_t mode = 0; mode < kModes; ++mode)
    tell(laws[mode],
         {{"paths", paths}, {"mode", std::string(name_of(static_cast<retime::Tempo>(mode)))}},
         result);
}

void random_paths(const RetimeStudyOptions& options, const StudyRun& study, StudyResult& result) {
  random_laws(
      "random", study.quick ? options.quick_paths : options.paths, study,
      [&](std::uint64_t index) { return random_path(options.seed, index); }, result);
  random_laws(
      "small", study.quick ? options.quick_small_paths : options.small_paths, study,
      [&](std::uint64_t index) { return small_path(options.seed, index); }, result);
}

void optimum(const RetimeStudyOptions& options, const StudyRun& study, StudyResult& result) {
  constexpr int kFine = 20000;
  struct Ratios {
    double law = 0, sampled = 0;
  };
  std::vector<double> law, sampled;
  parallel::for_each<Ratios>(
      study.quick ? options.quick_optimum_paths : options.optimum_paths, study.jobs,
      [&](std::uint64_t index) {
        RandomPath path =
            smooth_path(options.seed, index, 1 + static_cast<int>(index * 7 % 30), 200, 2);
        path.robot.jerk.setConstant(std::numeric_limits<double>::infinity());
        const Movement movement;
        const retime::PacedPath course = plain_course(path.robot, path.path, movement);
        const double least_s = reference_time(course, kFine);
        retime::RetimeOptions fastest;
        fastest.mode = retime::Tempo::fastest;
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
    result.rows.push_back(row_of(of, fmt::format("{}, largest", metric), "1",
                                 math::quantile(values, 1), values.size()));
    result.rows.back().at_most = at_most;
    result.rows.push_back(
        row_of(of, fmt::format("{}, mean", metric), "1", math::mean(values), values.size()));
  };
  row("law over the least time", law, 1.005);
  result.rows.push_back(
      row_of(of, "law over the least time, smallest", "1", math::quantile(law, 0), law.size()));
  result.rows.back().at_least = 0.995;
  row("samples over the least time", sampled, 1.02);
}

void trials(const RetimeStudyOptions& options, const StudyRun& study, StudyResult& result) {
  const std::filesystem::path folder = study.config.parent_path();
  const planning::LoadedConfig config = planning::load_config(folder / options.pipeline);
  const planning::Planner planner{config.options, config.robot};
  robot::Robot stronger = config.robot;
  stronger.velocity *= options.stronger;
  stronger.acceleration *= options.stronger;
  stronger.jerk *= options.stronger;
  imports::ImportRequest request;
  request.paths = {folder / options.manifest};
  int recordings = 0;
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    if (recordings++ >= (study.quick ? options.quick_trials : options.trials)) return;
    for (const Plan& plan : planning::plan_demonstration(planner, demonstration).plans) {
      if (!plan.has_trajectory()) continue;
      const auto row = [&](const char* robot, const char* metric, double value) -> StudyRow& {
        const Case of = {{"trial", demonstration.name}, {"limits", robot}};
        result.rows.push_back(row_of(of, metric, "1", value, 1));
        return result.rows.back();
      };
      const HumanTempo real = human_tempo(config.robot, plan.goals, plan.trajectory);
      row("the robot's", "tempo", real.tempo);
      row("the robot's", "share of time at the human's tempo", real.share);
      const Outcome<retime::RetimeResult> free =
          retime::retime(stronger, plan.path, plan.movement, config.options.retime);
      const HumanTempo kept = human_tempo(config.robot, plan.goals, free.value.trajectory);
      StudyRow& tempo = row("stronger", "tempo", kept.tempo);
      tempo.at_least = 0.9995;
      tempo.at_most = 1.0005;
      row("stronger", "share of time at the human's tempo", kept.share);
      row("stronger", "tip speeds, correlation with the human's", kept.correlation).at_least =
          0.999;
    }
    study.progress(demonstration.name);
  });
}

}  // namespace

std::string why_invalid(const RetimeStudyOptions& o) {
  if (std::min({o.paths, o.quick_paths, o.small_paths, o.quick_small_paths, o.optimum_paths,
                o.quick_optimum_paths}) < 1) {
    return "numbers of paths must be positive";
  }
  if (o.pipeline.empty() != o.manifest.empty()) return "pipeline and manifest go together";
  if (!(o.stronger >= 1)) return "stronger must be at least 1";
  return "";
}

StudyResult retime_study(const config::ConfigNode& config, const StudyRun& run) {
  RetimeStudyOptions options;
  config::read_document(config, options);
  StudyResult result;
  random_paths(options, run, result);
  optimum(options, run, result);
  if (!options.pipeline.empty()) trials(options, run, result);
  return result;
}

}  // namespace morphe::study
