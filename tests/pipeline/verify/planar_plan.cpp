#include "planar_plan.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::planar {
namespace {

const Eigen::Vector3d kFrom(0.2, 0.5, 0.2);
const Eigen::Vector3d kWay(0.5, 0.4, 0.3);
constexpr double kHuman_s = 0.8, kBegin_s = 2.0;

Pose shifted(double x, double z = 0) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec3(x, 0, z);
  return pose;
}

SceneObject fixed(const char* name, Shape shape, std::vector<double> size, const Vec3& position) {
  SceneObject object;
  object.name = name;
  object.shape = shape;
  object.size = std::move(size);
  object.time = {0};
  object.position = {position};
  object.orientation = {Quat::Identity()};
  return object;
}

Trajectory trajectory(double step_s) {
  Trajectory out;
  const int pieces = static_cast<int>(std::lround(1 / step_s));
  out.position.resize(pieces + 1, 3);
  out.velocity.resize(pieces + 1, 3);
  out.acceleration.resize(pieces + 1, 3);
  for (int k = 0; k <= pieces; ++k) {
    const double t = k == pieces ? 1.0 : k * step_s, rest = t * (1 - t);
    out.time.push_back(t);
    out.demonstration_time.push_back(kBegin_s + kHuman_s * t);
    out.phase.push_back(1);
    out.origin.push_back(Origin::mapped);
    out.clearance.push_back(0.005);
    out.position.row(k) = position_at(t);
    out.velocity.row(k) = 30 * rest * rest * kWay;
    out.acceleration.row(k) = 60 * rest * (1 - 2 * t) * kWay;
  }
  return out;
}

Goals goals() {
  constexpr std::size_t kFrames = 81;
  Goals out;
  out.tip_position = Table<Vec3>(kFrames, 2, unseen_point());
  out.tip_orientation = Table<Quat>(kFrames, 2, unseen_rotation());
  out.reachable = Table<std::uint8_t>(kFrames, 2, 1);
  out.finger_joint_position = Table<Vec3>(kFrames, kFingers, unseen_point());
  out.shoulder_position = out.elbow_position = out.wrist_position =
      std::vector<Vec3>(kFrames, unseen_point());
  out.wrist_orientation = std::vector<Quat>(kFrames, unseen_rotation());
  for (std::size_t k = 0; k < kFrames; ++k) {
    const double share = static_cast<double>(k) / 80;
    out.time.push_back(kBegin_s + kHuman_s * share);
    out.tip_position(k, 1) = tip_at(position_at(share));
  }
  return out;
}

/// Largest distance of the tip from the goals' polygon at the samples.
double polygon_error(const Plan& plan) {
  double largest = 0;
  for (const double t : plan.trajectory.time) {
    const double frame = std::min(80 * t, 79.999999);
    const auto k = static_cast<std::size_t>(frame);
    const double share = frame - static_cast<double>(k);
    const Vec3 goal =
        (1 - share) * plan.goals.tip_position(k, 1) + share * plan.goals.tip_position(k + 1, 1);
    largest = std::max(largest, (tip_at(position_at(t)) - goal).norm());
  }
  return largest;
}

}  // namespace

RobotTable robot() {
  RobotTable out;
  out.name = "planar";
  out.joint_names = {"shoulder", "elbow", "proximal"};
  out.lower = JointVector::Constant(3, -1.5);
  out.upper = JointVector::Constant(3, 1.5);
  out.velocity = JointVector::Constant(3, 2);
  out.acceleration = JointVector::Constant(3, 6);
  out.jerk = JointVector::Constant(3, 60);
  out.frames = {{"shoulder", -1, shifted(0, 0.1), Vec3::UnitZ(), 0, 1, 0},
                {"elbow", 0, shifted(0.3), Vec3::UnitZ(), 1, 1, 0},
                {"proximal", 1, shifted(0.25), Vec3::UnitZ(), 2, 1, 0},
                {"distal", 2, shifted(0.08), Vec3::UnitZ(), 2, 1, 0.1}};
  out.tips = {{"thumb", 2, shifted(0.02), 0}, {"index", 3, shifted(0.06), 1}};
  out.centres = {{1, "arm"}};
  out.capsules = {
      {"upper", 0, Vec3::Zero(), Vec3(0.25, 0, 0), 0.03, false},
      {"forearm", 1, Vec3::Zero(), Vec3(0.22, 0, 0), 0.03, false},
      {"proximal", 2, Vec3::Zero(), Vec3(0.08, 0, 0), 0.01, true},
      {"distal", 3, Vec3::Zero(), Vec3(0.06, 0, 0), 0.01, true},
  };
  out.allowed_pairs = {{0, 1}, {1, 2}, {2, 3}};
  return out;
}

Vec3 tip_at(const Eigen::Vector3d& q) {
  const double lengths[] = {0.3, 0.25, 0.08, 0.06};
  const double turns[] = {q(0), q(1), q(2), q(2) + 0.1};
  Vec3 tip(0, 0, 0.1);
  double angle = 0;
  for (int i = 0; i < 4; ++i) {
    angle += turns[i];
    tip += lengths[i] * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  return tip;
}

Eigen::Vector3d position_at(double t) {
  return kFrom + t * t * t * (10 - 15 * t + 6 * t * t) * kWay;
}

Plan plan(double step_s) {
  Plan out;
  out.demonstration = "reach";
  out.subject = "nobody";
  out.task = "reach";
  out.hand = "right";
  out.reason = "";
  out.movement = {0, kBegin_s, kBegin_s + kHuman_s, {}, "cup"};
  out.movement.phases = {{"reach", 2.0, 2.6, 1},
                         {"preshape", 2.3, 2.6, 1},
                         {"grasp", 2.6, 2.7, 1},
                         {"hold", 2.7, 2.8, 1}};
  out.trajectory = trajectory(step_s);
  out.goals = goals();

  const Eigen::Vector3d end = position_at(1);
  const double direction = end.sum() + end(2) + 0.1;
  const Vec3 cup =
      tip_at(end) + (0.01 + 0.03 - 0.002) * Vec3(std::cos(direction), std::sin(direction), 0);
  out.scene.objects = {fixed("bottle", Shape::cylinder, {0.02, 0.3}, Vec3(-0.5, -0.5, 0.2)),
                       fixed("cup", Shape::sphere, {0.03}, cup),
                       fixed("rod", Shape::capsule, {0.002, 0.3}, Vec3(-0.5, 0.5, 0.2)),
                       fixed("table", Shape::box, {2, 2, 0.1}, Vec3(0, 0, 0.065 - 0.05))};

  // Minimum jerk over 1 s: 15/8 of the way in velocity, 10/sqrt(3) in acceleration, 60 in jerk.
  out.certificate.position_margin = 1.5 - 0.9;
  out.certificate.velocity_ratio = 1.875 * 0.5 / 2;
  out.certificate.acceleration_ratio = 10 / std::sqrt(3.0) * 0.5 / 6;
  out.certificate.jerk_ratio = 60 * 0.5 / 60;
  out.certificate.clearance = 0.005;
  out.certificate.position_error_max = polygon_error(out);
  out.certificate.tempo = 1 / kHuman_s;
  return out;
}

}  // namespace morphe::planar
