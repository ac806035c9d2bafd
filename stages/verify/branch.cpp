#include "stages/verify/branch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {
namespace {

constexpr double kParallelSine = 0.0175;  ///< below which axes are parallel: one degree
constexpr double kElbowLever_m = 0.01;  ///< of shoulder and wrist about the elbow's axis, at least
/// Mean factor from which the sign of a path is beyond doubt: twice the factor that a posture near
/// a singularity may have, which the planner does not count.
constexpr double kDecidedMean = 0.1;
constexpr Eigen::Index kPostures = 100;  ///< of a trajectory, evenly spaced

/// An axis in the base frame.
using Line = Eigen::ParametrizedLine<double, 3>;

/// The hinges from the base to the palm at one posture, and the palm's origin.
struct Chain {
  std::vector<Line> axes;
  Vec3 palm;

  bool has(int k) const { return k >= 0 && k < static_cast<int>(axes.size()); }
  /// Returns the normal of two axes, of the length of the sine between them.
  Vec3 normal(int i, int k) const { return axes[i].direction().cross(axes[k].direction()); }
  bool crossed(int i, int k) const {
    return has(i) && has(k) && normal(i, k).norm() >= kParallelSine;
  }
};

Chain chain_at(const RobotModel& robot, const JointVector& q) {
  std::vector<Pose> base_from_frame;
  frame_poses(robot, q, base_from_frame);
  Chain chain{{}, base_from_frame[robot.palm_frame].translation()};
  for (int f = robot.palm_frame; f >= 0; f = robot.frames[f].parent) {
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint < 0 || frame.prismatic) continue;
    const Vec3 direction = base_from_frame[f].linear() * frame.axis;
    chain.axes.emplace_back(base_from_frame[f].translation(), direction);
  }
  std::ranges::reverse(chain.axes);
  return chain;
}

/// Returns the end on axis i of its common normal with axis k: in the plane that contains axis k
/// and this normal.
Vec3 end_of_common_normal(const Chain& chain, int i, int k) {
  const Vec3 plane_normal = chain.axes[k].direction().cross(chain.normal(i, k));
  const Vec3 &origin = chain.axes[i].origin(), &direction = chain.axes[i].direction();
  const double along =
      plane_normal.dot(chain.axes[k].origin() - origin) / plane_normal.dot(direction);
  return origin + along * direction;
}

Vec3 joint_centre(const Chain& chain, int i, int beyond, int elbow) {
  if (chain.crossed(i, beyond)) return end_of_common_normal(chain, i, beyond);
  if (chain.crossed(i, elbow)) return end_of_common_normal(chain, i, elbow);
  return chain.has(i + 1) ? chain.axes[i].origin() : chain.axes[i].projection(chain.palm);
}

/// The positions of shoulder and wrist relative to an axis, at right angles to it.
std::array<Vec3, 2> arms_of(const Chain& chain, int elbow) {
  const Vec3 shoulder = joint_centre(chain, elbow - 1, elbow - 2, elbow);
  const Vec3 wrist =
      chain.has(elbow + 1) ? joint_centre(chain, elbow + 1, elbow + 2, elbow) : chain.palm;
  const auto from_axis = [&](const Vec3& point) -> Vec3 {
    return point - chain.axes[elbow].projection(point);
  };
  return {from_axis(shoulder), from_axis(wrist)};
}

int elbow_of(const Chain& chain) {
  int elbow = -1;
  double best = 0;
  for (int k = 1; chain.has(k) && chain.axes.size() > 2; ++k) {
    const auto [shoulder, wrist] = arms_of(chain, k);
    const double size = shoulder.norm() * wrist.norm();
    if (std::min(shoulder.norm(), wrist.norm()) < kElbowLever_m || size <= best) continue;
    best = size;
    elbow = k;
  }
  return elbow;
}

/// Returns the determinant of three consecutive axes, relative to its largest value; 0 without one.
double relative_determinant(const Chain& chain, int middle) {
  if (!chain.crossed(middle - 1, middle) || !chain.crossed(middle, middle + 1)) return 0;
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k) axes.col(k) = chain.axes[middle - 1 + k].direction();
  return axes.determinant() /
         (chain.normal(middle - 1, middle).norm() * chain.normal(middle, middle + 1).norm());
}

double shoulder_factor(const Chain& chain, int elbow) {
  if (elbow > 2 && chain.crossed(0, 1) && chain.crossed(1, 2))
    return relative_determinant(chain, 1);
  if (elbow < 2 || !chain.crossed(0, 1)) return 0;
  const int wrist = std::min(elbow + 2, static_cast<int>(chain.axes.size()) - 2);
  const Vec3 away = joint_centre(chain, wrist, wrist + 1, -1) - joint_centre(chain, 0, 1, -1);
  return away.dot(chain.normal(0, 1)) / (away.norm() * chain.normal(0, 1).norm());
}

/// Returns the factors of shoulder, elbow and wrist, whose signs are the branch (docs/formats.md).
Vec3 factors(const Chain& chain, int elbow) {
  const auto [shoulder, wrist] = arms_of(chain, elbow);
  const double bend =
      chain.axes[elbow].direction().dot(wrist.cross(shoulder)) / (shoulder.norm() * wrist.norm());
  return {shoulder_factor(chain, elbow), bend, relative_determinant(chain, elbow + 2)};
}

}  // namespace

void verify_branch(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  constexpr std::array<const char*, 3> kParts{"shoulder", "elbow", "wrist"};
  if (!plan.branch.number || robot.palm_frame < 0) return;
  const int elbow = elbow_of(chain_at(robot, JointVector::Zero(robot.lower.size())));
  if (elbow < 0) return violations.note_plan("branch", "number", *plan.branch.number, kUnknown);
  const JointRows& path = plan.trajectory.position;
  Vec3 mean = Vec3::Zero();
  for (Eigen::Index k = 0; k < kPostures; ++k) {
    const JointVector q = path.row(k * (path.rows() - 1) / (kPostures - 1)).transpose();
    mean += factors(chain_at(robot, q), elbow) / static_cast<double>(kPostures);
  }
  for (int k = 0; k < 3; ++k) {
    const int stored = (*plan.branch.number >> k) & 1, own = mean[k] < 0 ? 1 : 0;
    if (std::abs(mean[k]) >= kDecidedMean && stored != own)
      violations.note_plan("branch", kParts[k], stored, own);
  }
}

}  // namespace morphe::verify
