#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "pipeline/store/demonstration_file.hpp"
#include "stages/commands.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe {
namespace {

using Json = nlohmann::ordered_json;

struct StreamSummary {
  std::string name;
  double duration_s = 0, rate_hz = 0, seen = 0;  ///< seen: share of values that are no NaN
};

StreamSummary summarise(const std::string& name, const std::vector<double>& time, double seen) {
  StreamSummary summary{name, 0, 0, seen};
  if (time.size() > 1) {
    summary.duration_s = time.back() - time.front();
    summary.rate_hz = static_cast<double>(time.size() - 1) / summary.duration_s;
  }
  return summary;
}

double seen_share(const Table<Vec3>& points) {
  if (points.values.empty()) return 0;
  const auto count = std::count_if(points.values.begin(), points.values.end(),
                                   [](const Vec3& point) { return seen(point); });
  return static_cast<double>(count) / static_cast<double>(points.values.size());
}

double seen_share(const JointRows& angles) {
  if (angles.size() == 0) return 0;
  return 1 -
         static_cast<double>(angles.array().isNaN().count()) / static_cast<double>(angles.size());
}

std::vector<StreamSummary> streams_of(const Streams& streams) {
  std::vector<StreamSummary> found;
  if (streams.markers) {
    found.push_back(
        summarise("markers", streams.markers->time, seen_share(streams.markers->position)));
  }
  if (streams.sensors) {
    found.push_back(
        summarise("sensors", streams.sensors->time, seen_share(streams.sensors->position)));
  }
  if (streams.skeleton) {
    found.push_back(
        summarise("skeleton", streams.skeleton->time, seen_share(streams.skeleton->position)));
  }
  if (streams.arm_angles) {
    found.push_back(
        summarise("arm_angles", streams.arm_angles->time, seen_share(streams.arm_angles->angles)));
  }
  if (streams.hand) {
    const bool points = !streams.hand->position.values.empty();
    found.push_back(
        summarise("hand", streams.hand->time,
                  points ? seen_share(streams.hand->position) : seen_share(streams.hand->angles)));
  }
  return found;
}

Json movement_json(const Movement& movement) {
  Json phases = Json::array();
  for (const Phase& phase : movement.phases) {
    phases.push_back({{"name", phase.name},
                      {"begin_s", phase.begin_s},
                      {"end_s", phase.end_s},
                      {"confidence", phase.confidence}});
  }
  return {{"begin_s", movement.begin_s}, {"end_s", movement.end_s}, {"phases", phases}};
}

Json inspect(const Demonstration& demonstration) {
  const HumanMotion motion = reconstruct(demonstration, {}, {});
  const std::vector<Movement> movements = segment(motion, {}, demonstration.objects);
  Json streams = Json::array(), found = Json::array();
  double duration_s = 0;
  for (const StreamSummary& stream : streams_of(demonstration.streams)) {
    streams.push_back({{"name", stream.name}, {"rate_hz", stream.rate_hz}, {"seen", stream.seen}});
    duration_s = std::max(duration_s, stream.duration_s);
  }
  for (const Movement& movement : movements) found.push_back(movement_json(movement));
  Json problems = motion.problems;
  if (problems.is_null()) problems = Json::array();
  if (movements.empty()) problems.push_back("no movement was found in it");
  return {{"name", demonstration.name},
          {"duration_s", duration_s},
          {"streams", streams},
          {"movements", found},
          {"problems", problems}};
}

void print(const Json& entry) {
  fmt::print("{}: {:.2f} s\n", entry["name"].get<std::string>(), entry["duration_s"].get<double>());
  for (const Json& stream : entry["streams"]) {
    fmt::print("  {:<10} {:7.2f} Hz, {:5.1f} % seen\n", stream["name"].get<std::string>(),
               stream["rate_hz"].get<double>(), 100 * stream["seen"].get<double>());
  }
  for (const Json& movement : entry["movements"]) {
    fmt::print("  movement {:.2f} to {:.2f} s:", movement["begin_s"].get<double>(),
               movement["end_s"].get<double>());
    for (const Json& phase : movement["phases"]) {
      fmt::print(" {} {:.2f}-{:.2f} ({:.0f} %)", phase["name"].get<std::string>(),
                 phase["begin_s"].get<double>(), phase["end_s"].get<double>(),
                 100 * phase["confidence"].get<double>());
    }
    fmt::print("\n");
  }
  for (const Json& problem : entry["problems"]) {
    fmt::print("  problem: {}\n", problem.get<std::string>());
  }
}

}  // namespace

Command inspect_command(CLI::App& app) {
  struct Arguments {
    std::string file;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("FILE", arguments->file, "demonstrations.h5")->required();
  app.add_flag("--json", arguments->json, "Print JSON");
  return [arguments] {
    const DemonstrationReader reader(arguments->file);
    Json all = Json::array();
    for (std::size_t i = 0; i < reader.size(); ++i) {
      Json entry = inspect(reader.read(i));
      if (arguments->json) {
        all.push_back(std::move(entry));
      } else {
        print(entry);
      }
    }
    if (arguments->json) fmt::print("{}\n", Json{{"demonstrations", all}}.dump(2));
    return 0;
  };
}

}  // namespace morphe
