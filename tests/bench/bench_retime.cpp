// Retiming 22 joints through 200 waypoints: the path's spline, the law within velocity and
// acceleration limits, and within jerk limits too, at 200, 500 and 1000 grid points; and a whole
// retime() with its samples at 500 Hz.
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "stages/retime/fit_path.hpp"
#include "stages/retime/retime.hpp"
#include "stages/retime/time_law.hpp"

namespace morphe {
namespace {

constexpr int kJoints = 22, kWaypoints = 200;

struct Problem {
  RobotModel robot;
  JointPath path;
  Movement movement;
};

Problem problem(bool jerk) {
  Problem out;
  out.robot.joint_names.assign(kJoints, "joint");
  out.robot.lower = JointVector::Constant(kJoints, -3);
  out.robot.upper = JointVector::Constant(kJoints, 3);
  out.robot.velocity = JointVector::Constant(kJoints, 1.5);
  out.robot.acceleration = JointVector::Constant(kJoints, 10);
  out.robot.jerk =
      JointVector::Constant(kJoints, jerk ? 100 : std::numeric_limits<double>::infinity());
  out.path.position.resize(kWaypoints, kJoints);
  for (int i = 0; i < kWaypoints; ++i) {
    const double t = 0.01 * i;
    out.path.demonstration_time.push_back(t);
    out.path.origin.push_back(SampleOrigin::mapped);
    for (int k = 0; k < kJoints; ++k) {
      out.path.position(i, k) =
          0.5 * std::sin(2 * t + 0.7 * k) + 0.1 * std::sin((4 + 0.2 * k) * t + k * k);
    }
  }
  return out;
}

retime::ConstrainedPath paced_path_of(const Problem& from) {
  retime::ConstrainedPath paced_path;
  paced_path.robot = &from.robot;
  paced_path.movement = &from.movement;
  paced_path.parameterized = retime::parameterize_path(from.robot, from.path, 0.01, true);
  const std::vector<double> allowance(paced_path.parameterized.parameter.size(), 1);
  paced_path.spline = retime::fit_path(from.robot, paced_path.parameterized.parameter,
                                       paced_path.parameterized.position, allowance, {}, 0.01)
                          .spline;
  paced_path.velocity = from.robot.velocity;
  paced_path.acceleration = from.robot.acceleration;
  paced_path.jerk = from.robot.jerk;
  return paced_path;
}

void path_building(benchmark::State& state) {
  const Problem from = problem(false);
  for (auto _ : state) benchmark::DoNotOptimize(paced_path_of(from).spline.coefficient.data());
}

/// `build`: the path is built each time. Points of the jerk law: knots and the middles between.
void law(benchmark::State& state, bool jerk, bool build) {
  const Problem from = problem(jerk);
  retime::ConstrainedPath paced_path = paced_path_of(from);
  double duration_s = 0;
  for (auto _ : state) {
    if (build) paced_path = paced_path_of(from);
    duration_s = retime::fastest_law(paced_path, state.range(0), state.range(0) / 2).duration_s;
    benchmark::DoNotOptimize(duration_s);
  }
  state.counters["duration_s"] = duration_s;
}

void whole(benchmark::State& state, bool jerk) {
  const Problem from = problem(jerk);
  retime::RetimeOptions options;
  options.mode = retime::RetimeMode::fastest;
  double duration_s = 0;
  for (auto _ : state) {
    duration_s =
        retime::retime(from.robot, from.path, from.movement, options).value.trajectory.time.back();
    benchmark::DoNotOptimize(duration_s);
  }
  state.counters["duration_s"] = duration_s;
}

#define GRIDS Arg(200)->Arg(500)->Arg(1000)->Unit(benchmark::kMillisecond)
BENCHMARK(path_building)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(law, velocity_acceleration, false, false)->GRIDS;
BENCHMARK_CAPTURE(law, velocity_acceleration_and_path, false, true)->GRIDS;
BENCHMARK_CAPTURE(law, jerk, true, false)->GRIDS;
BENCHMARK_CAPTURE(law, jerk_and_path, true, true)->GRIDS;
BENCHMARK_CAPTURE(whole, velocity_acceleration, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole, jerk, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace morphe

BENCHMARK_MAIN();
