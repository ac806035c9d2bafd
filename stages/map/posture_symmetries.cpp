#include "stages/map/posture_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
using std::numbers::pi;

JointVector apply_flip(const PostureSymmetries::SphericalFlip& flip, JointVector q) {
  q[flip.first] += pi;
  q[flip.middle] = 2 * flip.parallel_rad - q[flip.middle];
  q[flip.last] += pi;
  return q;
}

/// Returns q and every combination of flips, q itself first, regardless of the limits.
std::vector<JointVector> flip_combinations(const PostureSymmetries& symmetries,
                                           const JointVector& q) {
  std::vector<JointVector> combinations{q};
  for (const PostureSymmetries::SphericalFlip& flip : symmetries.flips) {
    for (std::ptrdiff_t k = 0, count = std::ssize(combinations); k < count; ++k) {
      combinations.push_back(apply_flip(flip, combinations[k]));
    }
  }
  return combinations;
}

int previous_joint_frame(const RobotModel& robot, int frame) {
  return robot::moving_frame_of(robot, robot.frames[frame].parent);
}

/// Returns a flip for all three consecutive hinges with the middle one orthogonal to both others.
std::vector<PostureSymmetries::SphericalFlip> possible_flips(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, JointVector::Zero(robot.lower.size()), base_from_frame);
  const auto axis = [&](int frame) -> Vec3 {
    return base_from_frame[frame].linear() * robot.frames[frame].axis;
  };
  std::vector<PostureSymmetries::SphericalFlip> flips;
  for (int last = 0; last < std::ssize(robot.frames); ++last) {
    const RobotModel::Frame& frame = robot.frames[last];
    const int middle = frame.joint < 0 ? -1 : previous_joint_frame(robot, last);
    const int first = middle < 0 ? -1 : previous_joint_frame(robot, middle);
    if (first < 0) continue;
    const Vec3 a = axis(first), b = axis(middle), c = axis(last);
    if (std::abs(a.dot(b)) > kOrthogonalityTolerance ||
        std::abs(c.dot(b)) > kOrthogonalityTolerance)
      continue;
    const RobotModel::Frame& hinge = robot.frames[middle];
    const double angle = std::atan2(b.dot(c.cross(a)), c.dot(a));  // turns c to a about b
    flips.push_back({robot.frames[first].joint, hinge.joint, frame.joint, angle / hinge.ratio});
  }
  return flips;
}

bool preserves_objective(const PostureSymmetries::SphericalFlip& flip,
                         const MappingProblem& problem) {
  std::mt19937_64 random(1);
  MappingScratch scratch;
  for (int k = 0; k < kSymmetryTestPostures; ++k) {
    const JointVector q = random_start(*problem.robot, random);
    for (const std::size_t frame : {std::size_t{0}, problem.frames() / 2, problem.frames() - 1}) {
      const double original = frame_objective(problem, frame, q, scratch);
      const double flipped = frame_objective(problem, frame, apply_flip(flip, q), scratch);
      if (!(std::abs(flipped - original) <= kSymmetryTolerance * std::abs(original))) return false;
    }
  }
  return true;
}

double limit_margin(const PostureSymmetries& symmetries, const JointVector& q) {
  double margin = std::numeric_limits<double>::infinity();
  for (const Index j : symmetry_joints(symmetries)) {
    margin = std::min({margin, q[j] - symmetries.lower[j], symmetries.upper[j] - q[j]});
  }
  return margin;
}

}  // namespace

PostureSymmetries find_posture_symmetries(const MappingProblem& problem) {
  const RobotModel& robot = *problem.robot;
  PostureSymmetries symmetries{{}, {}, robot.lower, robot.upper};
  for (const PostureSymmetries::SphericalFlip& flip : possible_flips(robot)) {
    if (std::ssize(symmetries.flips) == kMaxFlips) break;
    if (preserves_objective(flip, problem)) symmetries.flips.push_back(flip);
  }
  std::vector<Index>& multi_turn = symmetries.multi_turn_joints;
  for (Index j = 0; j < robot.lower.size() && std::ssize(multi_turn) < kMaxMultiTurnJoints; ++j) {
    if (robot.upper[j] - robot.lower[j] > 2 * pi) multi_turn.push_back(j);
  }
  return symmetries;
}

std::vector<Index> symmetry_joints(const PostureSymmetries& symmetries) {
  std::vector<Index> joints = symmetries.multi_turn_joints;
  for (const PostureSymmetries::SphericalFlip& flip : symmetries.flips) {
    joints.insert(joints.end(), {flip.first, flip.middle, flip.last});
  }
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

bool same_up_to_symmetry(const PostureSymmetries& symmetries, const JointVector& a,
                         const JointVector& b, double tolerance) {
  for (const JointVector& posture : flip_combinations(symmetries, b)) {
    double difference = 0;
    for (Index j = 0; j < a.size() && difference < tolerance; ++j) {
      difference = std::max(difference, std::abs(std::remainder(a[j] - posture[j], 2 * pi)));
    }
    if (difference < tolerance) return true;
  }
  return false;
}

std::vector<JointVector> equivalent_postures(const PostureSymmetries& symmetries,
                                             const JointVector& q) {
  std::vector<JointVector> postures;
  for (JointVector posture : flip_combinations(symmetries, q)) {
    // Moves the joint to the first whole turn above the lower limit.
    const auto turn_inside = [&](Index j) {
      posture[j] -= 2 * pi * std::floor((posture[j] - symmetries.lower[j]) / (2 * pi));
    };
    for (const Index j : symmetry_joints(symmetries)) {
      if (posture[j] < symmetries.lower[j] || posture[j] > symmetries.upper[j]) turn_inside(j);
    }
    std::ranges::for_each(symmetries.multi_turn_joints, turn_inside);
    std::vector<JointVector> turned{posture};
    for (const Index j : symmetries.multi_turn_joints) {
      if (posture[j] + 2 * pi > symmetries.upper[j]) continue;
      for (std::ptrdiff_t k = 0, count = std::ssize(turned); k < count; ++k) {
        turned.push_back(turned[k]);
        turned.back()[j] += 2 * pi;
      }
    }
    for (JointVector& inside : turned) {
      if ((inside.array() >= symmetries.lower.array()).all() &&
          (inside.array() <= symmetries.upper.array()).all()) {
        postures.push_back(std::move(inside));
      }
    }
  }
  std::ranges::stable_sort(postures, std::greater{},
                           [&](const JointVector& p) { return limit_margin(symmetries, p); });
  return postures;
}

}  // namespace morphe::map
