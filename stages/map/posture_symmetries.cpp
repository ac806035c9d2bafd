#include "stages/map/posture_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr std::size_t kMaxFlips = 4, kMaxMultiTurnJoints = 4;  ///< at most 2^8 equivalent postures

JointVector apply_flip(const PostureSymmetries::SphericalFlip& flip, JointVector q) {
  q[flip.first] += pi;
  q[flip.middle] = 2 * flip.parallel_rad - q[flip.middle];
  q[flip.last] += pi;
  return q;
}

/// Returns q and every combination of flips, q itself first, regardless of the limits.
std::vector<JointVector> flip_combinations(const PostureSymmetries& twins, const JointVector& q) {
  std::vector<JointVector> all{q};
  for (const PostureSymmetries::SphericalFlip& flip : twins.flips) {
    for (std::size_t k = 0, count = all.size(); k < count; ++k) {
      all.push_back(apply_flip(flip, all[k]));
    }
  }
  return all;
}

/// Returns the nearest frame before `frame` with a joint of its own; -1 if there is no such frame.
int previous_joint_frame(const RobotModel& robot, int frame) {
  const int before = robot.frames[frame].parent;
  for (const int f : robot::ancestors(robot, before)) {
    if (robot::joint_of(robot, f) >= 0) return f;
  }
  return -1;
}

/// Returns the flips suggested by the axes alone: all triples of consecutive hinges with the middle
/// one orthogonal to both others.
std::vector<PostureSymmetries::SphericalFlip> possible_flips(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, JointVector::Zero(robot.lower.size()), base_from_frame);
  const auto axis = [&](int frame) -> Vec3 {
    const auto f = static_cast<std::size_t>(frame);
    return base_from_frame[f].linear() * robot.frames[f].axis;
  };
  std::vector<PostureSymmetries::SphericalFlip> flips;
  for (int last = 0; last < static_cast<int>(robot.frames.size()); ++last) {
    const RobotModel::Frame& frame = robot.frames[last];
    const int middle = frame.joint < 0 ? -1 : previous_joint_frame(robot, last);
    const int first = middle < 0 ? -1 : previous_joint_frame(robot, middle);
    if (first < 0) continue;
    constexpr double kOrthogonalityTolerance = 1e-6;
    const Vec3 a = axis(first), b = axis(middle), c = axis(last);
    if (std::abs(a.dot(b)) > kOrthogonalityTolerance ||
        std::abs(c.dot(b)) > kOrthogonalityTolerance)
      continue;
    const RobotModel::Frame& hinge = robot.frames[middle];
    const double turn = std::atan2(b.dot(c.cross(a)), c.dot(a));  // angle that turns c to a about b
    flips.push_back({robot.frames[first].joint, hinge.joint, frame.joint, turn / hinge.ratio});
  }
  return flips;
}

bool preserves_objective(const PostureSymmetries::SphericalFlip& flip,
                         const MappingProblem& problem) {
  constexpr int kPostures = 3;
  constexpr double kRelativeTolerance = 1e-6;
  const RobotModel& robot = *problem.robot;
  std::mt19937_64 random(1);
  MappingScratch scratch;
  const auto value = [&](std::size_t frame, const JointVector& q) {
    scratch.model.reset(q.size());
    add_frame_objective(problem, frame, q, scratch, scratch.model, humanlike::Curvature::none);
    return scratch.model.value;
  };
  for (int k = 0; k < kPostures; ++k) {
    JointVector q(robot.lower.size());
    for (Index j = 0; j < q.size(); ++j) {
      const double share = static_cast<double>(random() >> 11) * 0x1p-53;
      q[j] = robot.lower[j] + share * (robot.upper[j] - robot.lower[j]);
    }
    for (const std::size_t frame : {std::size_t{0}, problem.frames() / 2, problem.frames() - 1}) {
      const double as_is = value(frame, q);
      if (!(std::abs(value(frame, apply_flip(flip, q)) - as_is) <=
            kRelativeTolerance * std::abs(as_is))) {
        return false;
      }
    }
  }
  return true;
}

/// Returns the least distance from a limit over the joints that differ among equivalent postures.
double limit_margin(const PostureSymmetries& twins, const JointVector& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index j : symmetry_joints(twins)) {
    least = std::min({least, q[j] - twins.lower[j], twins.upper[j] - q[j]});
  }
  return least;
}

}  // namespace

PostureSymmetries find_posture_symmetries(const MappingProblem& problem) {
  const RobotModel& robot = *problem.robot;
  PostureSymmetries symmetries{{}, {}, robot.lower, robot.upper};
  for (const PostureSymmetries::SphericalFlip& flip : possible_flips(robot)) {
    if (symmetries.flips.size() == kMaxFlips) break;
    if (preserves_objective(flip, problem)) symmetries.flips.push_back(flip);
  }
  for (Index j = 0;
       j < robot.lower.size() && symmetries.multi_turn_joints.size() < kMaxMultiTurnJoints; ++j) {
    if (robot.upper[j] - robot.lower[j] > 2 * pi) symmetries.multi_turn_joints.push_back(j);
  }
  return symmetries;
}

std::vector<Index> symmetry_joints(const PostureSymmetries& twins) {
  std::vector<Index> joints = twins.multi_turn_joints;
  for (const PostureSymmetries::SphericalFlip& flip : twins.flips) {
    joints.insert(joints.end(), {flip.first, flip.middle, flip.last});
  }
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

bool same_up_to_symmetry(const PostureSymmetries& twins, const JointVector& a, const JointVector& b,
                         double tolerance) {
  for (const JointVector& twin : flip_combinations(twins, b)) {
    double largest = 0;
    for (Index j = 0; j < a.size() && largest < tolerance; ++j) {
      largest = std::max(largest, std::abs(std::remainder(a[j] - twin[j], 2 * pi)));
    }
    if (largest < tolerance) return true;
  }
  return false;
}

std::vector<JointVector> equivalent_postures(const PostureSymmetries& twins, const JointVector& q) {
  std::vector<JointVector> found;
  for (JointVector twin : flip_combinations(twins, q)) {
    // Moves the joint to the first whole turn above the lower limit.
    const auto turn_inside = [&](Index j) {
      twin[j] -= 2 * pi * std::floor((twin[j] - twins.lower[j]) / (2 * pi));
    };
    for (const Index j : symmetry_joints(twins)) {
      if (twin[j] < twins.lower[j] || twin[j] > twins.upper[j]) turn_inside(j);
    }
    std::ranges::for_each(twins.multi_turn_joints, turn_inside);
    std::vector<JointVector> turned{twin};
    for (const Index j : twins.multi_turn_joints) {
      if (twin[j] + 2 * pi > twins.upper[j]) continue;
      for (std::size_t k = 0, count = turned.size(); k < count; ++k) {
        turned.push_back(turned[k]);
        turned.back()[j] += 2 * pi;
      }
    }
    for (JointVector& inside : turned) {
      if ((inside.array() >= twins.lower.array()).all() &&
          (inside.array() <= twins.upper.array()).all()) {
        found.push_back(std::move(inside));
      }
    }
  }
  std::ranges::stable_sort(found, std::greater{},
                           [&](const JointVector& twin) { return limit_margin(twins, twin); });
  return found;
}

}  // namespace morphe::map
