// Forward kinematics alone and with the Jacobians of all tips.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe {
namespace {

RobotModel robot_named(const std::string& name) {
  return robot::load_robot(std::filesystem::path(MORPHE_SOURCE_DIR) / "configs/robots" /
                           (name + ".yaml"))
      .table;
}

/// A posture inside the limits that is not special in any way.
JointVector posture(const RobotModel& robot) {
  JointVector q(robot.lower.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    q[i] = robot.lower[i] +
           (0.2 + 0.6 * static_cast<double>((7 * i) % 10) / 10) * (robot.upper[i] - robot.lower[i]);
  }
  return q;
}

void frames(benchmark::State& state, const std::string& name) {
  const RobotModel robot = robot_named(name);
  JointVector q = posture(robot);
  std::vector<Pose> base_from_frame;
  for (auto _ : state) {
    benchmark::DoNotOptimize(q.data());
    robot::forward_kinematics(robot, q, base_from_frame);
    benchmark::DoNotOptimize(base_from_frame.data());
    benchmark::ClobberMemory();
  }
}

void tip_points_one_by_one(benchmark::State& state, const std::string& name) {
  const RobotModel robot = robot_named(name);
  JointVector q = posture(robot);
  std::vector<Pose> base_from_frame;
  Eigen::Matrix3Xd point(3, q.size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(q.data());
    robot::forward_kinematics(robot, q, base_from_frame);
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      const Vec3 tip = robot::tip_pose(robot, base_from_frame, i).translation();
      robot::point_jacobian(robot, base_from_frame, robot.tips[i].frame, tip, point);
      benchmark::DoNotOptimize(point.data());
    }
    benchmark::ClobberMemory();
  }
}

void tips_at_once(benchmark::State& state, const std::string& name) {
  const RobotModel robot = robot_named(name);
  JointVector q = posture(robot);
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd jacobian(6 * static_cast<Eigen::Index>(robot.tips.size()), q.size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(q.data());
    robot::forward_kinematics(robot, q, base_from_frame);
    robot::tip_jacobians(robot, base_from_frame, jacobian);
    benchmark::DoNotOptimize(jacobian.data());
    benchmark::ClobberMemory();
  }
}

BENCHMARK_CAPTURE(frames, pa10, "pa10");
BENCHMARK_CAPTURE(frames, pa10_dlr_hit2, "pa10_dlr_hit2");
BENCHMARK_CAPTURE(tip_points_one_by_one, pa10, "pa10");
BENCHMARK_CAPTURE(tip_points_one_by_one, pa10_dlr_hit2, "pa10_dlr_hit2");
BENCHMARK_CAPTURE(frames, arm24_hand5, "arm24_hand5");
BENCHMARK_CAPTURE(tips_at_once, pa10, "pa10");
BENCHMARK_CAPTURE(tips_at_once, arm24_hand5, "arm24_hand5");
BENCHMARK_CAPTURE(tips_at_once, pa10_dlr_hit2, "pa10_dlr_hit2");

}  // namespace
}  // namespace morphe

BENCHMARK_MAIN();
