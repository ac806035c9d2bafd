#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "pipeline/study/plan_recordings.hpp"
#include "pipeline/study/study.hpp"
#include "pipeline/study/trade_off_options.hpp"
#include "pipeline/study/trade_off_output.hpp"

namespace morphe::study {
namespace {

std::vector<Demonstration> load_all(const std::vector<RecordingSource>& sources,
                                    const StudyRun& run) {
  std::vector<Demonstration> all;
  for (const RecordingSource& source : sources)
    std::ranges::move(load_recordings(source, run), std::back_inserter(all));
  return all;
}

struct Recordings {
  std::vector<Demonstration> choose, show;
};

/// The robots of a config with a value of a weight.
std::vector<planning::RobotConfig> load_value(const TradeOffStudyOptions& options,
                                              const std::filesystem::path& pipeline,
                                              const std::string& setting, bool quick) {
  std::vector<planning::RobotConfig> robots = planning::load_robots(pipeline, {setting});
  if (quick && std::ssize(robots) > options.quick_robots) robots.resize(options.quick_robots);
  for (planning::RobotConfig& robot : robots)
    if (robot.name.empty()) robot.name = robot.loaded.robot.name;
  return robots;
}

/// Adds the points of one value to the curves of the config's robots.
void add_value(const TradeOffStudyOptions& options, const std::filesystem::path& pipeline,
               const std::string& key, double value, const Recordings& recordings,
               const StudyRun& run, std::vector<RobotTradeOff>& robots) {
  const std::string setting = fmt::format("{}={}", key, value);
  const std::vector<planning::RobotConfig> loaded =
      load_value(options, pipeline, setting, run.quick);
  robots.resize(loaded.size());
  for (std::size_t k = 0; k < loaded.size(); ++k) {
    robots[k].robot = loaded[k].name;
    const auto plan = [&](const std::vector<Demonstration>& demonstrations, TradeOffCurve& curve) {
      if (demonstrations.empty()) return;
      curve.push_back(
          point_of(value, plan_recordings(loaded[k].loaded, demonstrations, run.jobs).plans));
      run.progress(
          fmt::format("{}, {}: {}", loaded[k].name, setting, point_sentence(curve.back())));
    };
    plan(recordings.choose, robots[k].choose);
    plan(recordings.show, robots[k].show);
  }
}

/// Keeps the least and the largest value of the first weight.
void keep_quick(TradeOffStudyOptions& options) {
  options.weights.resize(1);
  std::vector<double>& values = options.weights.front().values;
  values = {values.front(), values.back()};
}

}  // namespace

std::string validation_error(const ComparedWeight& weight) {
  if (weight.values.size() < 2) return "values: needs at least two values";
  if (!std::ranges::is_sorted(weight.values, std::ranges::less_equal{}))
    return "values: must ascend";
  return "";
}

std::string validation_error(const TradeOffStudyOptions& options) {
  if (options.pipelines.empty()) return "pipelines is empty";
  if (options.weights.empty()) return "weights is empty";
  if (options.choose.empty()) return "choose is empty";
  return "";
}

StudyResult trade_off_study(const config::ConfigNode& config, const StudyRun& run) {
  TradeOffStudyOptions options;
  config::read_document(config, options);
  if (run.quick) keep_quick(options);
  const Recordings recordings{load_all(options.choose, run), load_all(options.show, run)};
  StudyResult result;
  for (const ComparedWeight& weight : options.weights) {
    std::vector<RobotTradeOff> all;
    for (const std::string& pipeline : options.pipelines) {
      std::vector<RobotTradeOff> robots;
      for (const double value : weight.values)
        add_value(options, run.config.parent_path() / pipeline, weight.key, value, recordings, run,
                  robots);
      std::ranges::move(robots, std::back_inserter(all));
    }
    add_trade_off(weight.key, all, result);
  }
  return result;
}

}  // namespace morphe::study
