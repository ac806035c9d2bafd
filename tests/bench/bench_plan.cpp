// The planner of the repair on MotionBenchMaker's problems: solved, certified, milliseconds.
//   bench_plan [--problems DIR] [--iterations N] [--range R] [--margin M] [--json OUT]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "core/robot/files/description.hpp"
#include "stages/repair/connect.hpp"
#include "stages/repair/path_smoothing.hpp"
#include "stages/repair/repair_options.hpp"
#include "tests/support/moveit_problem.hpp"

namespace morphe {
namespace {

namespace fs = std::filesystem;
/// Of this thread alone, so that what else the machine does counts as little as possible.
double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Options {
  fs::path problems = fs::path(MORPHE_SOURCE_DIR) / "datasets/motionbenchmaker";
  fs::path robot;  ///< panda.yaml of the same folder if empty
  int iterations = 20000, shortcuts = repair::RepairOptions{}.shortcut_attempts;
  double range = repair::RepairOptions{}.range, margin_m = Tolerances{}.required_clearance;
  unsigned threads = 1;
  std::string json;  ///< file of the figures, if any
};

struct Problem {
  std::string set, name;
  fs::path scene, request;
};

std::vector<Problem> problems_in(const fs::path& folder) {
  std::vector<Problem> problems;
  for (const auto& set : fs::directory_iterator(folder)) {
    if (!set.is_directory()) continue;
    for (const auto& file : fs::directory_iterator(set)) {
      const std::string name = file.path().filename().string();
      if (!name.starts_with("scene")) continue;
      problems.push_back({set.path().filename().string(), name.substr(5, 4), file.path(),
                          set.path() / ("request" + name.substr(5))});
    }
  }
  std::sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return a.set != b.set ? a.set < b.set : a.name < b.name;
  });
  return problems;
}

struct Answer {
  double plan_ms = 0, shorten_ms = 0, length = 0, shortened = 0;  ///< lengths [rad]
  bool solved = false, certified = false;
  std::string why;
  std::vector<JointVector> path;
};

double length_of(const std::vector<JointVector>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

Answer solve(const Problem& problem, const robot::RobotDescription& robot, const Options& options) {
  const moveit::PlanningProblem asked =
      moveit::read_moveit_problem(problem.scene, problem.request, robot);
  Tolerances tolerances;
  tolerances.required_clearance = options.margin_m;
  const robot::Robot of(asked.robot);
  const collision::CollisionWorld world = collision::make_world(of, asked.scene, {}, tolerances);
  const repair::IntervalWorld interval =
      repair::interval_world(world, 0, 0, 0, repair::TouchRule::strict);
  const repair::ConnectSpace space{of.arm_joints, of.lower, of.upper};
  Answer answer;
  collision::CollisionScratch scratch;
  if (!collision::is_free(world, asked.start, 0, scratch)) answer.why = "start in collision";
  if (asked.goals.front().lower != asked.goals.front().upper) answer.why = "no joint goal";
  const JointVector& goal = asked.goals.front().lower;
  if (answer.why.empty() && !collision::is_free(world, goal, 0, scratch))
    answer.why = "goal in collision";
  if (!answer.why.empty()) {
    const collision::PairSeparation pair =
        collision::least_slack(world, answer.why[0] == 's' ? asked.start : goal, 0, scratch);
    answer.why += fmt::format(": {} - {}, {:.4f} m", collision::first_body_name(world, pair),
                              collision::second_body_name(world, pair), pair.slack());
    return answer;
  }
  double begin = processor_ms();
  answer.path = repair::plan_rrt_connect(interval, space, asked.start, goal, options.iterations,
                                         options.range, 1);
  answer.plan_ms = processor_ms() - begin;
  answer.solved = !answer.path.empty();
  if (!answer.solved) {
    answer.why = "no path";
    return answer;
  }
  answer.length = length_of(answer.path);
  begin = processor_ms();
  std::mt19937_64 random(1);
  answer.path = repair::shortcut(interval, std::move(answer.path), options.shortcuts, random);
  answer.shorten_ms = processor_ms() - begin;
  answer.shortened = length_of(answer.path);
  answer.certified = true;
  for (std::size_t i = 1; i < answer.path.size(); ++i) {
    const collision::JointMotion edge =
        collision::straight_motion(answer.path[i - 1], answer.path[i], 0, 0);
    answer.certified &=
        collision::check_motion(world, edge, scratch).verdict == collision::MotionVerdict::free;
  }
  return answer;
}

std::vector<Answer> solve_all(const std::vector<Problem>& problems,
                              const robot::RobotDescription& robot, const Options& options) {
  std::vector<Answer> answers(problems.size());
  std::vector<std::jthread> threads;
  for (unsigned t = 0; t < options.threads; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < problems.size(); i += options.threads) {
        answers[i] = solve(problems[i], robot, options);
      }
    });
  }
  threads.clear();
  return answers;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print(const std::string& name, const std::vector<const Answer*>& answers) {
  std::vector<double> plan, shorten, length, shortened;
  std::size_t certified = 0;
  for (const Answer* answer : answers) {
    if (!answer->solved) continue;
    certified += answer->certified ? 1 : 0;
    plan.push_back(answer->plan_ms);
    shorten.push_back(answer->shorten_ms);
    length.push_back(answer->length);
    shortened.push_back(answer->shortened);
  }
  fmt::print("{:<22} {:>3} of {:>3} {:>9} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", name,
             plan.size(), answers.size(), certified, percentile(plan, 0.5), percentile(plan, 0.95),
             percentile(shorten, 0.5), percentile(length, 0.5), percentile(shortened, 0.5));
}

using Json = nlohmann::ordered_json;

/// As docs/formats.md says: a row for each set, and every problem.
void write_json(const std::string& file, const std::vector<Problem>& problems,
                const std::vector<Answer>& answers,
                const std::map<std::string, std::vector<const Answer*>>& sets) {
  Json rows = Json::array(), all = Json::array();
  for (const auto& [name, of] : sets) {
    std::vector<double> us;
    std::size_t solved = 0, certified = 0;
    for (const Answer* answer : of) {
      if (answer->solved) us.push_back(1e3 * answer->plan_ms);
      solved += answer->solved ? 1 : 0;
      certified += answer->certified ? 1 : 0;
    }
    rows.push_back(
        {{"case", name},
         {"n", of.size()},
         {"ours", {{"median_us", percentile(us, 0.5)}, {"p99_us", percentile(us, 0.99)}}},
         {"errors", {{"unsolved", of.size() - solved}, {"uncertified", of.size() - certified}}},
         {"peers", Json::object()}});
  }
  for (std::size_t i = 0; i < problems.size(); ++i) {
    Json path = Json::array();
    for (const JointVector& q : answers[i].path)
      path.push_back(std::vector<double>(q.begin(), q.end()));
    all.push_back({{"name", problems[i].set + "/" + problems[i].name},
                   {"solved", answers[i].solved},
                   {"certified", answers[i].certified},
                   {"time_ms", answers[i].plan_ms},
                   {"path", path}});
  }
  const Json json{{"bench", "plan"}, {"preset", MORPHE_PRESET}, {"rows", rows}, {"problems", all}};
  std::ofstream(file) << json.dump(1) << "\n";
}

int run(const Options& options) {
  const std::vector<Problem> problems = problems_in(options.problems);
  const robot::RobotDescription robot =
      robot::load_robot(options.robot.empty() ? options.problems / "panda.yaml" : options.robot);
  const std::vector<Answer> answers = solve_all(problems, robot, options);
  fmt::print("{:<22} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "", "solved", "certified",
             "ms 50 %", "ms 95 %", "+ shorten", "rad 50 %", "shortened");
  std::map<std::string, std::vector<const Answer*>> sets;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    sets[problems[i].set].push_back(&answers[i]);
    sets["~ all"].push_back(&answers[i]);
    if (!answers[i].why.empty()) {
      fmt::print("  {}/{}: {}\n", problems[i].set, problems[i].name, answers[i].why);
    }
  }
  for (const auto& [name, of] : sets) print(name, of);
  if (!options.json.empty()) write_json(options.json, problems, answers, sets);
  // The same once more, on two threads: to the bit.
  Options again = options;
  again.threads = 2;
  const std::vector<Answer> second = solve_all(problems, robot, again);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    equal += answers[i].path == second[i].path ? 1 : 0;
  }
  fmt::print("again, two threads: {} of {} paths equal to the bit\n", equal, problems.size());
  return equal == problems.size() ? 0 : 1;
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  CLI::App app{"The planner of the repair on MotionBenchMaker's problems"};
  morphe::Options options;
  app.add_option("--problems", options.problems,
                 "folder of sets of sceneNNNN and requestNNNN.yaml");
  app.add_option("--robot", options.robot, "description, panda.yaml of that folder by default");
  app.add_option("--iterations", options.iterations);
  app.add_option("--shortcuts", options.shortcuts);
  app.add_option("--range", options.range, "longest edge, in shares of the joints' spans");
  app.add_option("--margin", options.margin_m, "[m]");
  app.add_option("--json", options.json, "file of the figures");
  CLI11_PARSE(app, argc, argv);
  return morphe::run(options);
}
