#include "stages/verify/posture_errors.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/goal_errors.hpp"
#include "stages/verify/tracking.hpp"

namespace morphe::verify {
namespace {

constexpr double kLeastElbowShare = 0.1, kLeastWristSpeed_m_s = 1e-3;

/// Mean and maximum of the finite values.
struct PostureStatistics {
  double total = 0, largest = kUnknown;
  int count = 0;
  void add(double value) {
    if (!std::isfinite(value)) return;
    total += value;
    largest = std::fmax(largest, value);
    ++count;
  }
  void store(double& mean, double& max) const {
    mean = count > 0 ? total / count : kUnknown;
    max = largest;
  }
};

/// Shoulder, elbow and wrist as columns; NaN for a point that the arm does not have.
using ArmColumns = Eigen::Matrix3d;

/// Returns the robot's arm: its shoulder frame, the arm's joint centres, and the tip of the wrist
/// or, if there is only one centre and no such tip, the palm.
ArmColumns arm_of(const RobotModel& robot, const std::vector<Pose>& poses) {
  std::vector<Vec3> points{to_base_frame(poses, robot.shoulder_frame, Vec3::Zero())};
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    if (centre.chain == "arm") points.push_back(to_base_frame(poses, centre.frame, Vec3::Zero()));
  ArmColumns arm = ArmColumns::Constant(kUnknown);
  if (points.size() == 1) return arm;
  for (const RobotModel::Tip& tip : robot.tips)
    if (tip.finger < 0)
      points.push_back(to_base_frame(poses, tip.frame, tip.transform.translation()));
  if (points.size() == 2) points.push_back(to_base_frame(poses, robot.palm_frame, Vec3::Zero()));
  arm.col(0) = points.front();
  if (points.size() == 3) arm.col(1) = points[1];
  arm.col(2) = points.back();
  return arm;
}

Vec3 point_between(const std::vector<Vec3>& points, const GoalInterpolation& mix) {
  if (points.empty()) return unknown_point();
  return points[mix.before] + mix.share * (points[mix.after] - points[mix.before]);
}

ArmColumns arm_of(const Goals& goals, const GoalInterpolation& mix) {
  ArmColumns arm;
  arm << point_between(goals.shoulder_position, mix), point_between(goals.elbow_position, mix),
      point_between(goals.wrist_position, mix);
  return arm;
}

double angle_between_vectors(const Vec3& a, const Vec3& b) {
  const Vec3 u = a.normalized(), v = b.normalized();
  return 2 * std::atan2((u - v).norm(), (u + v).norm());
}

/// An arm's unit vector from shoulder to wrist, and the elbow's distance vector from that line.
struct Swivel {
  Vec3 line, offset;
  bool defined = false;
};
Swivel swivel_of(const ArmColumns& arm) {
  Swivel swivel;
  const Vec3 upper = arm.col(1) - arm.col(0), fore = arm.col(2) - arm.col(1);
  swivel.line = (arm.col(2) - arm.col(0)).normalized();
  swivel.offset = swivel.line.cross(upper.cross(swivel.line));
  swivel.defined = swivel.offset.norm() >= kLeastElbowShare * (upper.norm() + fore.norm());
  return swivel;
}

/// Returns the magnitude of the swivel angle between two arms; the first is turned about the common
/// perpendicular of the two lines until they agree.
double swivel_between(const ArmColumns& human, const ArmColumns& robot) {
  const Swivel from = swivel_of(human), to = swivel_of(robot);
  const double cosine = from.line.dot(to.line);
  if (!from.defined || !to.defined || !(cosine > 0)) return kUnknown;
  const Vec3 across = from.line.cross(to.line);
  const Vec3 turned = from.offset + across.cross(from.offset) +
                      across.cross(across.cross(from.offset)) / (1 + cosine);
  return angle_between_vectors(turned, to.offset);
}

std::optional<Eigen::Vector4d> hand_rotation(const Goals& goals, const GoalInterpolation& mix) {
  if (goals.wrist_orientation.empty()) return std::nullopt;
  const Eigen::Vector4d from = goals.wrist_orientation[mix.before].coeffs();
  const Eigen::Vector4d to = goals.wrist_orientation[mix.after].coeffs();
  if (!from.allFinite() || !to.allFinite()) return std::nullopt;
  return slerp(from, to, mix.share);
}

/// Returns where on the curve a demonstration time is reached first.
double time_at(const Trajectory& motion, double demonstration_s) {
  const std::vector<double>& clock = motion.demonstration_time;
  std::size_t k = 0;
  while (k < clock.size() && clock[k] < demonstration_s) ++k;
  if (k == 0) return motion.time.front();
  if (k == clock.size()) return motion.time.back();
  const double share = (demonstration_s - clock[k - 1]) / (clock[k] - clock[k - 1]);
  return motion.time[k - 1] + share * (motion.time[k] - motion.time[k - 1]);
}

Vec3 wrist_at(const RobotModel& robot, const Curve& curve, double time_s) {
  const std::vector<double>& time = curve.trajectory->time;
  const auto after = std::ranges::upper_bound(time, time_s) - time.begin();
  const int piece = static_cast<int>(std::clamp<std::ptrdiff_t>(after - 1, 0, curve.pieces - 1));
  JointVector q;
  std::vector<Pose> poses;
  curve.position_at(piece, std::min(1.0, (time_s - time[piece]) / (time[piece + 1] - time[piece])),
                    q);
  frame_poses(robot, q, poses);
  return arm_of(robot, poses).col(2);
}

double pearson(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  double mean_a = 0, mean_b = 0, ab = 0, aa = 0, bb = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    mean_a += a[k] / n;
    mean_b += b[k] / n;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

double speed_correlation(const RobotModel& robot, const Plan& plan, const Curve& curve) {
  const std::vector<double>& clock = plan.goals.time;
  const std::vector<Vec3>& wrist = plan.goals.wrist_position;
  if (wrist.size() != clock.size() || curve.pieces < 1) return kUnknown;
  std::vector<double> reached_s, human, driven;
  std::vector<Vec3> own;
  for (const double demonstration_s : clock) {
    reached_s.push_back(time_at(plan.trajectory, demonstration_s));
    own.push_back(wrist_at(robot, curve, reached_s.back()));
  }
  for (std::size_t k = 2; k < clock.size(); ++k) {
    const double human_speed = (wrist[k] - wrist[k - 2]).norm() / (clock[k] - clock[k - 2]);
    const double speed = (own[k] - own[k - 2]).norm() / (reached_s[k] - reached_s[k - 2]);
    if (!std::isfinite(human_speed) || !std::isfinite(speed)) continue;
    human.push_back(human_speed);
    driven.push_back(speed);
  }
  const auto moves = [](const std::vector<double>& speed) {
    return std::ranges::any_of(speed, [](double v) { return v > kLeastWristSpeed_m_s; });
  };
  return human.size() >= 2 && moves(human) && moves(driven) ? pearson(human, driven) : kUnknown;
}

}  // namespace

void recompute_posture(const RobotModel& robot, const Plan& plan, const Curve& curve,
                       Certificate& own) {
  if (plan.goals.frames() == 0) return;
  PostureStatistics forearm, swivel, palm;
  std::vector<Pose> poses;
  for (int sample = 0; sample < std::ssize(plan.trajectory.time); ++sample) {
    const GoalInterpolation mix =
        interpolate_goal_frames(plan.goals, plan.trajectory.demonstration_time[sample]);
    frame_poses(robot, plan.trajectory.position.row(sample).transpose(), poses);
    const ArmColumns human = arm_of(plan.goals, mix), arm = arm_of(robot, poses);
    forearm.add(angle_between_vectors(human.col(2) - human.col(1), arm.col(2) - arm.col(1)));
    swivel.add(swivel_between(human, arm));
    if (const auto hand = hand_rotation(plan.goals, mix))
      palm.add(rotation_angle(poses[robot.palm_frame], *hand));
  }
  forearm.store(own.forearm_error_mean, own.forearm_error_max);
  swivel.store(own.swivel_error_mean, own.swivel_error_max);
  palm.store(own.palm_error_mean, own.palm_error_max);
  own.wrist_speed_correlation = speed_correlation(robot, plan, curve);
}

}  // namespace morphe::verify
