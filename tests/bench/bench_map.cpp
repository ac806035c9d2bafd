// Microseconds a frame and errors of the mapping's solvers on the same 90 Hz movements:
//   bench_map [WORD ...]   only problems whose names contain one of the words
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/solve/minimise.hpp"
#include "core/solve/trust_region.hpp"
#include "tests/bench/bench_map_problems.hpp"
#ifdef MORPHE_KDL
#include "tests/bench/bench_map_kdl.hpp"
#endif

namespace morphe {
namespace {

/// Of this thread alone, so that what else the machine does counts as little as possible.
double processor_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return kUnknown;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// One solver on one robot: everything that is allocated once.
struct Solver {
  const BenchProblem* bench;
  solve::MinimiseOptions options;
  solve::BoundedProblem problem;
  humanlike::ObjectiveScratch scratch;
  solve::TrustRegionScratch structured;
  solve::Quadratic model;
  const humanlike::FrameGoal* goal = nullptr;

  Solver(const BenchProblem& b, const std::string& algorithm) : bench(&b) {
    options.algorithm = algorithm;
    problem.lower = b.robot.lower;
    problem.upper = b.robot.upper;
    model.reset(problem.lower.size());
    problem.objective = [this](const JointVector& q, JointVector* gradient) {
      model.value = 0;
      model.gradient.setZero();
      humanlike::add_objective(bench->objective, bench->robot, q, *goal, scratch, model,
                               humanlike::Curvature::none);
      if (gradient) *gradient = model.gradient;
      return model.value;
    };
    problem.model = [this](const JointVector& q, solve::Quadratic& out) {
      humanlike::add_objective(bench->objective, bench->robot, q, *goal, scratch, out,
                               humanlike::Curvature::exact);
    };
  }
  Solver(const Solver&) = delete;

  solve::Minimum solve(const humanlike::FrameGoal& at, const JointVector& start) {
    goal = &at;
    scratch.new_descent();
    if (options.algorithm == "trust_region") {
      return solve::minimise_trust_region(problem, start, options, structured);
    }
    return solve::minimise(problem, start, options);
  }
};

struct Row {
  std::string name;
  std::vector<double> time_us, position_mm, orientation_deg, value;
  double evaluations = 0;
};

void measure_errors(const BenchProblem& bench, const humanlike::FrameGoal& goal,
                    const JointVector& q, std::vector<Pose>& poses, Row& row) {
  robot::forward_kinematics(bench.robot, q, poses);
  for (std::size_t i = 0; i < bench.robot.tips.size(); ++i) {
    const Pose tip = robot::tip_pose(bench.robot, poses, i);
    row.position_mm.push_back(1e3 * (tip.translation() - goal.tip_position[i]).norm());
    if (!is_known(goal.tip_orientation[i])) continue;
    row.orientation_deg.push_back(180 / std::numbers::pi *
                                  angle_between(Quat(tip.linear()), goal.tip_orientation[i]));
  }
}

JointVector random_position(const RobotModel& robot, std::mt19937_64& random) {
  JointVector q(robot.lower.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    q[j] = std::uniform_real_distribution<>(robot.lower[j], robot.upper[j])(random);
  }
  return q;
}

solve::Minimum best_of(Solver& solver, const humanlike::FrameGoal& goal, int starts,
                       std::uint64_t seed) {
  std::mt19937_64 random(seed);
  solve::Minimum best;
  best.value = std::numeric_limits<double>::infinity();
  for (int i = 0; i < starts; ++i) {
    solve::Minimum found = solver.solve(goal, random_position(solver.bench->robot, random));
    if (found.value < best.value) best = std::move(found);
  }
  return best;
}

/// Follows every movement, each frame from the last one's solution, or from both last ones'
/// continued in a straight line.
Row follow(Solver& solver, const std::vector<JointVector>& first, bool extrapolate) {
  Row row;
  std::vector<Pose> poses;
  for (std::size_t m = 0; m < solver.bench->movements.size(); ++m) {
    JointVector last = first[m], before = first[m], start;
    for (const humanlike::FrameGoal& goal : solver.bench->movements[m]) {
      const double begin = processor_us();
      start = extrapolate ? JointVector(2 * last - before) : last;
      solve::Minimum found = solver.solve(goal, start);
      row.time_us.push_back(processor_us() - begin);
      row.value.push_back(found.value);
      row.evaluations += found.evaluations;
      before = last;
      last = found.x;
      measure_errors(*solver.bench, goal, last, poses, row);
    }
  }
  row.evaluations /= static_cast<double>(row.time_us.size());
  return row;
}

#ifdef MORPHE_KDL
Row follow_kdl(const BenchProblem& bench, const std::vector<JointVector>& first, double& solved) {
  KdlArm arm(bench.robot);
  Row row;
  std::vector<Pose> poses;
  solved = 0;
  for (std::size_t m = 0; m < bench.movements.size(); ++m) {
    JointVector q = first[m];
    for (const humanlike::FrameGoal& goal : bench.movements[m]) {
      const Pose target = make_pose(goal.tip_position[0], goal.tip_orientation[0]);
      const double begin = processor_us();
      solved += arm.solve(target, q) ? 1 : 0;
      row.time_us.push_back(processor_us() - begin);
      measure_errors(bench, goal, q, poses, row);
    }
  }
  solved /= static_cast<double>(row.time_us.size());
  return row;
}
#endif

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// `best`: the lowest F that any solver found in each frame.
void print(const Row& row, const Row& reference, const std::vector<double>& best) {
  fmt::print("  {:<22} {:>8.1f} {:>8.1f} {:>6.1f} {:>6.2f} | {:>8.4f} {:>8.4f} {:>8.4f} {:>8.4f} |",
             row.name, percentile(row.time_us, 0.5), percentile(row.time_us, 0.99),
             percentile(row.time_us, 0.5) / percentile(reference.time_us, 0.5), row.evaluations,
             percentile(row.position_mm, 0.5), percentile(row.position_mm, 0.99),
             percentile(row.orientation_deg, 0.5), percentile(row.orientation_deg, 0.99));
  if (!row.value.empty()) {
    std::vector<double> excess = row.value;
    int worse = 0;
    for (std::size_t i = 0; i < best.size(); ++i) {
      excess[i] -= best[i];
      worse += excess[i] > 1e-3 ? 1 : 0;
    }
    fmt::print(" {:.9f} {:8.1e} {:8.1e} {:5.1f} %", mean(row.value), percentile(excess, 0.5),
               percentile(excess, 0.9), 100.0 * worse / static_cast<double>(best.size()));
  }
  fmt::print("\n");
}

void print_cold(const BenchProblem& bench, Solver& solver) {
  for (const int starts : {1, 8, 16, 64}) {
    std::vector<double> time_us;
    int global = 0, count = 0;
    for (std::size_t m = 0; m < bench.movements.size(); ++m) {
      for (const std::size_t f : {std::size_t{0}, bench.movements[m].size() / 2}) {
        const humanlike::FrameGoal& goal = bench.movements[m][f];
        const double best = best_of(solver, goal, 200, 77).value;
        const double begin = processor_us();
        const double found = best_of(solver, goal, starts, 3 + m).value;
        time_us.push_back(processor_us() - begin);
        global += found < best + 1e-3 ? 1 : 0;
        ++count;
      }
    }
    fmt::print("  cold, {:>2} starts: {:.2f} ms median, {:.2f} ms 99 %; best of 200 in {} of {}\n",
               starts, 1e-3 * percentile(time_us, 0.5), 1e-3 * percentile(time_us, 0.99), global,
               count);
  }
}

void run(const BenchProblem& bench) {
  fmt::print("{} ({} variables)\n", bench.name, bench.robot.joints());
  fmt::print(
      "  {:<22} {:>8} {:>8} {:>6} {:>6} | {:>17} {:>17} | mean F, excess 50 %, 90 %, frames > "
      "1e-3\n",
      "", "us 50 %", "us 99 %", "ratio", "evals", "mm 50 %, 99 %", "deg 50 %, 99 %");
  Solver structured(bench, "trust_region");
  std::vector<JointVector> first;
  for (std::size_t m = 0; m < bench.movements.size(); ++m) {
    first.push_back(structured.solve(bench.movements[m][0], bench.begin[m]).x);
  }
  std::vector<Row> rows;
  for (const char* algorithm : {"trust_region", "tnewton", "slsqp"}) {
    Solver solver(bench, algorithm);
    for (const bool extrapolate : {false, true}) {
      rows.push_back(follow(solver, first, extrapolate));
      rows.back().name = fmt::format("{}{}", algorithm, extrapolate ? ", extrapolated" : "");
    }
  }
  std::vector<double> best = rows[0].value;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < best.size(); ++i) best[i] = std::min(best[i], row.value[i]);
  }
#ifdef MORPHE_KDL
  if (bench.robot.tips.size() == 1 && bench.robot.joints() == 7) {
    double solved = 0;
    rows.push_back(follow_kdl(bench, first, solved));
    rows.back().name = fmt::format("KDL NR_JL, {:.1f} % met", 100 * solved);
  }
#endif
  for (const Row& row : rows) print(row, rows[0], best);
  print_cold(bench, structured);
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  using namespace morphe;
  const std::string robots = MORPHE_SOURCE_DIR "/configs/robots/";
  const robot::Robot arm(robot::load_robot(robots + "pa10.yaml").table);
  const robot::Robot arm_hand(robot::load_robot(robots + "pa10_dlr_hit2.yaml").table);
  std::vector<std::pair<std::string, const robot::Robot*>> cases = {
      {"arm 7, wrist pose", &arm},
      {"arm-hand 22, fingertip positions", &arm_hand},
      {"arm-hand 22, fingertip positions and orientations", &arm_hand}};
  std::vector<robot::Robot> hyper;
  for (const int n : {9, 21, 27, 44})
    hyper.emplace_back(robot::generate_arm({n, 0.5775, std::numbers::pi / 2}));
  for (const robot::Robot& robot : hyper) {
    cases.emplace_back(fmt::format("arm {}, wrist pose", robot.joints()), &robot);
  }
  for (const auto& [name, robot] : cases) {
    for (const bool noise : {false, true}) {
      const std::string full = name + (noise ? ", noise" : ", clean");
      const bool wanted = argc < 2 || std::any_of(argv + 1, argv + argc, [&](const char* word) {
                            return full.find(word) != std::string::npos;
                          });
      if (!wanted) continue;
      const bool orientations = name.find("positions") == std::string::npos ||
                                name.find("orientations") != std::string::npos;
      run(make_bench_problem(full, *robot, {orientations, noise}));
    }
  }
  return 0;
}
