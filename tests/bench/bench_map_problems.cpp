#include "tests/bench/bench_map_problems.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include "core/robot/forward_kinematics.hpp"

namespace morphe {
namespace {

constexpr int kMovements = 12, kFrames = 91;
constexpr double kDegree = std::numbers::pi / 180;

struct Noise {
  std::mt19937_64 random{2};
  double size = 1;
  double normal(double deviation) {
    return size * std::normal_distribution<>(0, deviation)(random);
  }
  Vec3 vector(double deviation) {
    return Vec3(normal(deviation), normal(deviation), normal(deviation));
  }
  Quat turn(double deviation) {
    const Vec3 v = vector(deviation);
    return v.norm() == 0 ? Quat::Identity() : Quat(Eigen::AngleAxisd(v.norm(), v.normalized()));
  }
};

humanlike::FrameGoal goal_at(const RobotModel& robot, JointVector q, bool orientations,
                             Noise& noise) {
  for (std::size_t j = 0; j < robot.joints(); ++j) {
    const bool finger =
        std::any_of(kFingerNames, kFingerNames + kFingerCount,
                    [&](const char* name) { return robot.joint_names[j].starts_with(name); });
    if (finger) q[static_cast<Eigen::Index>(j)] += noise.normal(kDegree);
  }
  q = q.cwiseMax(robot.lower).cwiseMin(robot.upper);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const auto origin = [&](int frame) -> Vec3 {
    return poses[static_cast<std::size_t>(frame)].translation();
  };
  // The tracker sits on the hand: its noise moves all tips alike.
  const Vec3 hand = origin(robot.palm_frame), shift = noise.vector(0.76e-3);
  const Quat turn = noise.turn(0.15 * kDegree);
  const auto sensed = [&](const Vec3& p) -> Vec3 { return hand + shift + turn * (p - hand); };

  humanlike::FrameGoal goal;
  for (std::size_t i = 0; i < robot.tips.size(); ++i) {
    const Pose tip = robot::tip_pose(robot, poses, i);
    goal.tip_position.push_back(sensed(tip.translation()));
    goal.tip_orientation.push_back(orientations ? turn * Quat(tip.linear()) : unknown_rotation());
  }
  const Vec3 shoulder = origin(robot.shoulder_frame);
  for (const auto& centre : robot.joint_centres) {
    if (centre.chain == "arm") {
      goal.elbow =
          shoulder + 0.323 * (origin(centre.frame) - shoulder).normalized() + noise.vector(0.76e-3);
      break;
    }
  }
  goal.finger_joint.fill(unknown_point());
  for (const auto& centre : robot.joint_centres) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      if (centre.chain == kFingerNames[finger]) {
        goal.finger_joint[finger] = sensed(origin(centre.frame)) + turn * Vec3(0.01, 0, 0.005);
      }
    }
  }
  return goal;
}

}  // namespace

BenchProblem make_bench_problem(const std::string& name, const robot::Robot& robot,
                                const BenchGoals& goals) {
  BenchProblem problem;
  problem.name = name;
  problem.robot = robot;
  problem.objective.get<humanlike::TipPosition>().weight = 10000;
  problem.objective.get<humanlike::TipOrientation>().weight = robot.tips.size() == 1 ? 1 : 0.1;
  problem.objective.get<humanlike::HandOrientation>().weight = 0.01;
  problem.objective.get<humanlike::JointDistance>().weight = 1;
  problem.objective.get<humanlike::NaturalPosture>().weight = 1e-3;
  problem.objective.get<humanlike::FingerJointDistance>().weight = 0.1;
  std::mt19937_64 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  Noise noise;
  noise.size = goals.noise ? 1 : 0;
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const double reach = 0.6 * std::min(1.0, std::sqrt(7.0 / static_cast<double>(joints)));
  for (int m = 0; m < kMovements; ++m) {
    JointVector from(joints), to(joints);
    for (Eigen::Index j = 0; j < joints; ++j) {
      const double low = robot.lower[j], high = robot.upper[j];
      from[j] = uniform(0.7 * low + 0.3 * high, 0.3 * low + 0.7 * high);
      to[j] = std::clamp(from[j] + uniform(-reach, reach), 0.9 * low + 0.1 * high,
                         0.1 * low + 0.9 * high);
    }
    std::vector<humanlike::FrameGoal> movement;
    for (int f = 0; f < kFrames; ++f) {
      const double s = f / (kFrames - 1.0), share = s * s * s * (10 - s * (15 - 6 * s));
      movement.push_back(goal_at(robot, from + share * (to - from), goals.orientations, noise));
    }
    problem.movements.push_back(std::move(movement));
    problem.begin.push_back(from);
  }
  return problem;
}

}  // namespace morphe
