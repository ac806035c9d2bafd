#include "stages/map/posture_symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "core/robot/arm_branch.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

constexpr double kTurn_rad = 2 * std::numbers::pi;

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

/// Returns the whole turns [rad] of a joint that moves between `least` and `greatest` to where it
/// is nearest to the reference, but not wound up unless that is; without a reference, to the middle
/// of its range. They lead out of the limits only if all turns do.
double preferred_turn(const PostureSymmetries& symmetries, Index j, double least, double greatest) {
  const double lower = symmetries.lower[j], upper = symmetries.upper[j];
  const bool has_reference = symmetries.reference.size() > 0;
  const double goal = has_reference ? symmetries.reference[j] : (lower + upper) / 2;
  double turn = kTurn_rad * std::round((goal - (least + greatest) / 2) / kTurn_rad);
  while (greatest + turn > upper) turn -= kTurn_rad;
  while (least + turn < lower) turn += kTurn_rad;
  if (has_reference && robot::wound_turns(lower, upper, goal, goal) != 0) return turn;
  return turn - kTurn_rad * robot::wound_turns(lower, upper, least + turn, greatest + turn);
}

bool is_inside(const PostureSymmetries& symmetries, const JointRows& path) {
  return (path.colwise().minCoeff().transpose().array() >= symmetries.lower.array()).all() &&
         (path.colwise().maxCoeff().transpose().array() <= symmetries.upper.array()).all();
}

/// Returns true if the flip is one of the arm and leaves the palm where it is.
bool preserves_palm(const robot::SphericalFlip& flip, const RobotModel& robot) {
  if (!robot::joint_moves_frame(robot, flip.last, robot.palm_frame)) return false;  // of a finger
  std::mt19937_64 random(1);
  std::vector<Pose> poses, flipped;
  for (int k = 0; k < kSymmetryTestPostures; ++k) {
    const JointVector q = random_start(robot, random);
    robot::forward_kinematics(robot, q, poses);
    robot::forward_kinematics(robot, robot::apply_flip(flip, q), flipped);
    const Pose &palm = poses[robot.palm_frame], &moved = flipped[robot.palm_frame];
    if ((palm.translation() - moved.translation()).norm() > kSamePlace_m ||
        angle_between(Quat(palm.linear()), Quat(moved.linear())) > kSameTurn_rad)
      return false;
  }
  return true;
}

template <class Preserved>
PostureSymmetries find_symmetries(const MappingProblem& problem, const Preserved& is_preserved) {
  const RobotModel& robot = *problem.robot;
  PostureSymmetries symmetries{{}, {}, robot.lower, robot.upper, problem.reference.posture};
  for (const robot::SphericalFlip& flip : robot::possible_flips(robot)) {
    if (std::ssize(symmetries.flips) == kMaxFlips) break;
    if (is_preserved(flip)) symmetries.flips.push_back(flip);
  }
  for (int j = 0; j < robot.lower.size(); ++j) {
    if (robot.upper[j] - robot.lower[j] > kTurn_rad && !robot::is_prismatic(robot, j))
      symmetries.multi_turn_joints.push_back(j);
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
      difference = std::max(difference, std::abs(std::remainder(a[j] - posture[j], kTurn_rad)));
    }
    if (difference < tolerance) return true;
  }
  return false;
}

std::vector<JointVector> equivalent_postures(const PostureSymmetries& symmetries,
                                             const JointVector& q) {
  std::vector<JointVector> postures;
  for (const JointVector& posture : flip_combinations(symmetries, q)) {
    const JointRows turned = turned_towards_reference(symmetries, posture.transpose());
    if (is_inside(symmetries, turned)) postures.push_back(turned.row(0).transpose());
  }
  std::ranges::stable_sort(postures, {}, [&](const JointVector& p) {
    return symmetries.reference.size() > 0 ? preference_of(symmetries, p.transpose())
                                           : Preference{0, -limit_margin(symmetries, p)};
  });
  return postures;
}

JointRows turned_towards_reference(const PostureSymmetries& symmetries, JointRows path) {
  for (const Index j : symmetry_joints(symmetries)) {
    auto column = path.col(j).array();
    column += preferred_turn(symmetries, j, column.minCoeff(), column.maxCoeff());
  }
  return path;
}

JointVector turned_off_limits(const PostureSymmetries& symmetries, const JointRows& path,
                              JointVector q) {
  for (const Index j : symmetries.multi_turn_joints) {
    const bool at_upper = path.col(j).maxCoeff() >= symmetries.upper[j];
    const bool at_lower = path.col(j).minCoeff() <= symmetries.lower[j];
    if (at_upper && q[j] - kTurn_rad >= symmetries.lower[j]) q[j] -= kTurn_rad;
    if (at_lower && q[j] + kTurn_rad <= symmetries.upper[j]) q[j] += kTurn_rad;
  }
  return q;
}

JointRows preferred_equivalent(const PostureSymmetries& symmetries, const JointRows& path) {
  JointRows preferred = turned_towards_reference(symmetries, path);
  if (symmetries.reference.size() == 0) return preferred;
  Preference least = preference_of(symmetries, preferred);
  const std::size_t combinations = std::size_t{1} << symmetries.flips.size();
  for (std::size_t k = 1; k < combinations; ++k) {
    JointRows equivalent(path.rows(), path.cols());
    for (Index f = 0; f < path.rows(); ++f)
      equivalent.row(f) = flip_combinations(symmetries, path.row(f).transpose())[k].transpose();
    equivalent = turned_towards_reference(symmetries, std::move(equivalent));
    const Preference preference = preference_of(symmetries, equivalent);
    if (!is_inside(symmetries, equivalent) || preference >= least) continue;
    least = preference;
    preferred = std::move(equivalent);
  }
  return preferred;
}

}  // namespace morphe::map
