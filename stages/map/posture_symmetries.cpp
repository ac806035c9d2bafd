#include "stages/map/posture_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "core/robot/forward_kinematics.hpp"
#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
using std::numbers::pi;

/// Returns q and every combination of flips, q itself first, regardless of the limits.
std::vector<JointVector> flip_combinations(const PostureSymmetries& symmetries,
                                           const JointVector& q) {
  std::vector<JointVector> combinations{q};
  for (const robot::SphericalFlip& flip : symmetries.flips) {
    for (std::ptrdiff_t k = 0, count = std::ssize(combinations); k < count; ++k) {
      combinations.push_back(robot::apply_flip(flip, combinations[k]));
    }
  }
  return combinations;
}

bool preserves_objective(const robot::SphericalFlip& flip, const MappingProblem& problem) {
  std::mt19937_64 random(1);
  MappingScratch scratch;
  for (int k = 0; k < kSymmetryTestPostures; ++k) {
    const JointVector q = random_start(*problem.robot, random);
    for (const std::size_t frame : {std::size_t{0}, problem.frames() / 2, problem.frames() - 1}) {
      const double original = frame_objective(problem, frame, q, scratch);
      const double flipped = frame_objective(problem, frame, robot::apply_flip(flip, q), scratch);
      if (!(std::abs(flipped - original) <= kSymmetryTolerance * std::abs(original))) return false;
    }
  }
  return true;
}

/// The order in which equivalent postures or paths are preferred: fewest sides of flips that differ
/// from the reference's, then the least distance to it.
using Preference = std::pair<int, double>;

Preference preference_of(const PostureSymmetries& symmetries, const JointRows& path) {
  const JointVector& reference = symmetries.reference;
  int other_sides = 0;
  for (const robot::SphericalFlip& flip : symmetries.flips) {
    const double side = (path.col(flip.middle).array() - flip.parallel_rad).sin().sum();
    if (side * std::sin(reference[flip.middle] - flip.parallel_rad) < 0) ++other_sides;
  }
  return {other_sides, (path.rowwise() - reference.transpose()).squaredNorm()};
}

double limit_margin(const PostureSymmetries& symmetries, const JointVector& q) {
  double margin = std::numeric_limits<double>::infinity();
  for (const Index j : symmetry_joints(symmetries)) {
    margin = std::min({margin, q[j] - symmetries.lower[j], symmetries.upper[j] - q[j]});
  }
  return margin;
}

bool preserves_palm(const robot::SphericalFlip& flip, const RobotModel& robot) {
  std::mt19937_64 random(1);
  const JointVector q = random_start(robot, random);
  std::vector<Pose> poses, flipped;
  robot::forward_kinematics(robot, q, poses);
  robot::forward_kinematics(robot, robot::apply_flip(flip, q), flipped);
  return poses[robot.palm_frame].isApprox(flipped[robot.palm_frame], kSymmetryTolerance);
}

template <class Preserved>
PostureSymmetries find_symmetries(const MappingProblem& problem, const Preserved& is_preserved) {
  const RobotModel& robot = *problem.robot;
  PostureSymmetries symmetries{{}, {}, robot.lower, robot.upper, problem.reference.posture};
  for (const robot::SphericalFlip& flip : robot::possible_flips(robot)) {
    if (std::ssize(symmetries.flips) == kMaxFlips) break;
    if (is_preserved(flip)) symmetries.flips.push_back(flip);
  }
  std::vector<Index>& multi_turn = symmetries.multi_turn_joints;
  for (Index j = 0; j < robot.lower.size() && std::ssize(multi_turn) < kMaxMultiTurnJoints; ++j) {
    if (robot.upper[j] - robot.lower[j] > 2 * pi) multi_turn.push_back(j);
  }
  return symmetries;
}

}  // namespace

PostureSymmetries find_posture_symmetries(const MappingProblem& problem) {
  return find_symmetries(problem, [&](const robot::SphericalFlip& flip) {
    return preserves_objective(flip, problem);
  });
}

PostureSymmetries find_palm_symmetries(const MappingProblem& problem) {
  return find_symmetries(problem, [&](const robot::SphericalFlip& flip) {
    return preserves_palm(flip, *problem.robot);
  });
}

std::vector<Index> symmetry_joints(const PostureSymmetries& symmetries) {
  std::vector<Index> joints = symmetries.multi_turn_joints;
  for (const robot::SphericalFlip& flip : symmetries.flips) {
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
  std::ranges::stable_sort(postures, {}, [&](const JointVector& p) {
    return symmetries.reference.size() > 0 ? preference_of(symmetries, p.transpose())
                                           : Preference{0, -limit_margin(symmetries, p)};
  });
  return postures;
}

JointRows preferred_equivalent(const PostureSymmetries& symmetries, const JointRows& path) {
  if (symmetries.reference.size() == 0) return path;
  const std::vector<Index> joints = symmetry_joints(symmetries);
  JointRows preferred = path;
  Preference least = preference_of(symmetries, path);
  const std::size_t combinations = std::size_t{1} << symmetries.flips.size();
  for (std::size_t k = 0; k < combinations; ++k) {
    JointRows equivalent(path.rows(), path.cols());
    for (Index f = 0; f < path.rows(); ++f)
      equivalent.row(f) = flip_combinations(symmetries, path.row(f).transpose())[k].transpose();
    for (const Index j : joints) {
      auto column = equivalent.col(j).array();
      column += 2 * pi * std::round((symmetries.reference[j] - column.mean()) / (2 * pi));
      if (column.maxCoeff() > symmetries.upper[j]) column -= 2 * pi;
      if (column.minCoeff() < symmetries.lower[j]) column += 2 * pi;
    }
    const bool inside =
        (equivalent.colwise().minCoeff().transpose().array() >= symmetries.lower.array()).all() &&
        (equivalent.colwise().maxCoeff().transpose().array() <= symmetries.upper.array()).all();
    const Preference preference = preference_of(symmetries, equivalent);
    if (!inside || preference >= least) continue;
    least = preference;
    preferred = std::move(equivalent);
  }
  return preferred;
}

}  // namespace morphe::map
