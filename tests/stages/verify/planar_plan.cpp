#include "planar_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

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
    const double now_s = out.demonstration_time.back();
    out.phase.push_back(now_s < 2.3   ? PhaseKind::reach
                        : now_s < 2.6 ? PhaseKind::preshape
                        : now_s < 2.7 ? PhaseKind::grasp
                                      : PhaseKind::hold);
    out.origin.push_back(SampleOrigin::mapped);
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
  out.tip_position = Array2D<Vec3>(kFrames, 2, unknown_point());
  out.tip_orientation = Array2D<Quat>(kFrames, 2, unknown_rotation());
  out.reachable = Array2D<std::uint8_t>(kFrames, 2, 1);
  out.finger_joint_position = Array2D<Vec3>(kFrames, kFingerCount, unknown_point());
  out.shoulder_position = out.elbow_position = out.wrist_position =
      std::vector<Vec3>(kFrames, unknown_point());
  out.wrist_orientation = std::vector<Quat>(kFrames, unknown_rotation());
  for (std::size_t k = 0; k < kFrames; ++k) {
    const double share = static_cast<double>(k) / 80;
    out.time.push_back(kBegin_s + kHuman_s * share);
    out.tip_position(k, 1) = tip_at(position_at(share));
  }
  return out;
}

/// Every frame is met.
void map_goals(Plan& plan) {
  const auto frames = static_cast<Eigen::Index>(plan.goals.frames());
  MappingResult& mapped = plan.mapped;
  mapped.position.resize(frames, 3);
  mapped.tip_error = mapped.tip_orientation_error = JointRows::Constant(frames, 2, kUnknown);
  mapped.humanlikeness = JointRows::Constant(frames, 3, kUnknown);
  for (Eigen::Index k = 0; k < frames; ++k) {
    mapped.position.row(k) = position_at(static_cast<double>(k) / static_cast<double>(frames - 1));
    mapped.tip_error(k, 1) = 0;
    mapped.objective.push_back(0);
    mapped.status.push_back(FrameStatus::met);
    plan.path.origin.push_back(SampleOrigin::mapped);
  }
  plan.path.position = mapped.position;
  plan.path.demonstration_time = plan.goals.time;
}

/// Distances of the tip from the goals' polygon at the samples from a demonstration time on.
std::vector<double> polygon_errors(const Plan& plan, double from_s = 0) {
  std::vector<double> errors;
  for (const double t : plan.trajectory.time) {
    if (kBegin_s + kHuman_s * t < from_s) continue;
    const double frame = std::min(80 * t, 79.999999);
    const auto k = static_cast<std::size_t>(frame);
    const double share = frame - static_cast<double>(k);
    const Vec3 goal =
        (1 - share) * plan.goals.tip_position(k, 1) + share * plan.goals.tip_position(k + 1, 1);
    errors.push_back((tip_at(position_at(t)) - goal).norm());
  }
  return errors;
}

/// Speeds of the tip over two steps of 10 ms each, the whole way in so many steps.
std::vector<double> tip_speeds(int steps) {
  std::vector<double> speeds;
  const auto tip = [&](int k) { return tip_at(position_at(static_cast<double>(k) / steps)); };
  for (int k = 1; k < steps; ++k) speeds.push_back((tip(k + 1) - tip(k - 1)).norm() / 0.02);
  return speeds;
}

/// As their papers have them, term by term.
double spectral_arc_length(const std::vector<double>& v) {
  std::size_t padded = 16;
  while (padded < 16 * v.size()) padded *= 2;
  const double bin_hz = 100.0 / static_cast<double>(padded);
  std::vector<double> size;
  std::size_t last = 0;
  for (std::size_t k = 0; static_cast<double>(k) * bin_hz <= 10; ++k) {
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      sum += v[i] * std::exp(std::complex<double>(
                        0, -0.02 * std::numbers::pi * bin_hz * static_cast<double>(k * i)));
    }
    size.push_back(std::abs(sum) / (k == 0 ? 1 : size[0]));
    if (k > 0 && size[k] >= 0.05) last = k;
  }
  size[0] = 1;
  double length = 0;
  for (std::size_t k = 0; k < last; ++k) {
    length +=
        std::sqrt(std::pow(1 / static_cast<double>(last), 2) + std::pow(size[k + 1] - size[k], 2));
  }
  return -length;
}

double log_dimensionless_jerk(const std::vector<double>& v) {
  double integral = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    integral += std::pow((v[i + 1] - 2 * v[i] + v[i - 1]) / 1e-4, 2) * 0.01;
  }
  const double peak = *std::max_element(v.begin(), v.end());
  const double duration_s = 0.01 * static_cast<double>(v.size() - 1);
  return -std::log(std::pow(duration_s, 3) / (peak * peak) * integral);
}

}  // namespace

RobotModel robot() {
  RobotModel out;
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
  out.joint_centres = {{1, "arm"}};
  out.capsules = {
      {"upper", 0, Vec3::Zero(), Vec3(0.25, 0, 0), 0.03, false},
      {"forearm", 1, Vec3::Zero(), Vec3(0.22, 0, 0), 0.03, false},
      {"proximal", 2, Vec3::Zero(), Vec3(0.08, 0, 0), 0.01, true},
      {"distal", 3, Vec3::Zero(), Vec3(0.06, 0, 0), 0.01, true},
  };
  out.allowed_collision_pairs = {{0, 1}, {1, 2}, {2, 3}};
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

Grasp grasp_at(const Plan& plan, int sample) {
  const Eigen::Vector3d q = plan.trajectory.position.row(sample).transpose();
  // A point of the proximal link, so far from its joint, or of the distal one.
  const auto point = [&](double proximal, double distal) {
    const double lengths[] = {0.3, 0.25, proximal, distal};
    const double turns[] = {q(0), q(1), q(2), q(2) + 0.1};
    Vec3 at(0, 0, 0.1);
    double angle = 0;
    for (int i = 0; i < 4; ++i) {
      angle += turns[i];
      at += lengths[i] * Vec3(std::cos(angle), std::sin(angle), 0);
    }
    return at;
  };
  Grasp grasp;
  grasp.sample = sample;
  grasp.base_from_object.translation() = plan.scene.objects[1].position[0];
  grasp.grasp_posture = q;
  // The distal link bends more and more, so that the tips come nearer to each other.
  grasp.pregrasp_posture = position_at(0);
  // The palm is the shoulder's frame, at height 0.1 m, turned by the first joint.
  Pose base_from_palm = Pose::Identity();
  base_from_palm.translation() = Vec3(0, 0, 0.1);
  base_from_palm.linear() = Eigen::AngleAxisd(q(0), Vec3::UnitZ()).toRotationMatrix();
  const Pose object_from_base = grasp.base_from_object.inverse();
  grasp.object_from_palm = object_from_base * base_from_palm;
  grasp.tips_in_object = {object_from_base * point(0.02, 0), object_from_base * point(0.08, 0.06)};
  return grasp;
}

Plan plan(double step_s) {
  Plan out;
  out.demonstration = "reach";
  out.subject = "nobody";
  out.task = "reach";
  out.hand = Side::right;
  out.reason = Reason::none;
  out.movement = {0, kBegin_s, kBegin_s + kHuman_s, {}, "cup"};
  out.movement.phases = {{PhaseKind::reach, 2.0, 2.6, 1},
                         {PhaseKind::preshape, 2.3, 2.6, 1},
                         {PhaseKind::grasp, 2.6, 2.7, 1},
                         {PhaseKind::hold, 2.7, 2.8, 1}};
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
  out.scene.objects[1].attach_s = 2.7;
  out.scene.objects[1].release_s = 2.8;
  map_goals(out);
  const auto& reached = out.trajectory.demonstration_time;
  out.grasp =
      grasp_at(out, static_cast<int>(std::ranges::lower_bound(reached, 2.6) - reached.begin()));

  // Minimum jerk over 1 s: 15/8 of the way in velocity, 10/sqrt(3) in acceleration, 60 in jerk.
  out.certificate.joint_limit_margin = 1.5 - 0.9;
  out.certificate.velocity_ratio = 1.875 * 0.5 / 2;
  out.certificate.acceleration_ratio = 10 / std::sqrt(3.0) * 0.5 / 6;
  out.certificate.jerk_ratio = 60 * 0.5 / 60;
  out.certificate.clearance = 0.005;
  const std::vector<double> errors = polygon_errors(out), grasp = polygon_errors(out, 2.6);
  out.certificate.tip_error_max = *std::max_element(errors.begin(), errors.end());
  out.certificate.tip_error_mean =
      std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
  out.certificate.tip_error_grasp = *std::max_element(grasp.begin(), grasp.end());
  out.certificate.sparc_robot = spectral_arc_length(tip_speeds(100));
  out.certificate.sparc_human = spectral_arc_length(tip_speeds(80));
  out.certificate.log_dimensionless_jerk_robot = log_dimensionless_jerk(tip_speeds(100));
  out.certificate.log_dimensionless_jerk_human = log_dimensionless_jerk(tip_speeds(80));
  out.certificate.duration_ratio = 1 / kHuman_s;
  return out;
}

}  // namespace morphe::planar
