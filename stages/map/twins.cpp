#include "stages/map/twins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
using std::numbers::pi;

constexpr std::size_t kMostFlips = 4, kMostTurning = 4;  ///< at most 2^8 twins

JointVector flipped(const Twins::Flip& flip, JointVector q) {
  q[flip.first] += pi;
  q[flip.middle] = 2 * flip.parallel - q[flip.middle];
  q[flip.last] += pi;
  return q;
}

/// Every combination of flips, q itself first; not yet within the limits.
std::vector<JointVector> all_flipped(const Twins& twins, const JointVector& q) {
  std::vector<JointVector> all{q};
  for (const Twins::Flip& flip : twins.flips) {
    for (std::size_t k = 0, count = all.size(); k < count; ++k) {
      all.push_back(flipped(flip, all[k]));
    }
  }
  return all;
}

/// The nearest frame before `frame` with a joint of its own; -1: none.
int hinge_before(const RobotTable& robot, int frame) {
  const int before = robot.frames[static_cast<std::size_t>(frame)].parent;
  for (const int f : robot::upwards(robot, before)) {
    if (robot::joint_of(robot, f) >= 0) return f;
  }
  return -1;
}

/// Flips by their axes alone: all triples of hinges in a row with the middle one square to both.
std::vector<Twins::Flip> possible_flips(const RobotTable& robot) {
  std::vector<Pose> base_from_frame;
  robot::forward(robot, JointVector::Zero(robot.lower.size()), base_from_frame);
  const auto axis = [&](int frame) -> Vec3 {
    const auto f = static_cast<std::size_t>(frame);
    return base_from_frame[f].linear() * robot.frames[f].axis;
  };
  std::vector<Twins::Flip> flips;
  for (int last = 0; last < static_cast<int>(robot.frames.size()); ++last) {
    const RobotTable::Frame& frame = robot.frames[static_cast<std::size_t>(last)];
    const int middle = frame.joint < 0 ? -1 : hinge_before(robot, last);
    const int first = middle < 0 ? -1 : hinge_before(robot, middle);
    if (first < 0) continue;
    constexpr double kSquare = 1e-6;
    const Vec3 a = axis(first), b = axis(middle), c = axis(last);
    if (std::abs(a.dot(b)) > kSquare || std::abs(c.dot(b)) > kSquare) continue;
    const RobotTable::Frame& hinge = robot.frames[static_cast<std::size_t>(middle)];
    const double turn = std::atan2(b.dot(c.cross(a)), c.dot(a));  // takes c to a about b
    flips.push_back({robot.frames[static_cast<std::size_t>(first)].joint, hinge.joint, frame.joint,
                     turn / hinge.ratio});
  }
  return flips;
}

bool leaves_objective(const Twins::Flip& flip, const MappingProblem& problem) {
  constexpr int kPostures = 3;
  constexpr double kRelative = 1e-6;
  const RobotTable& robot = *problem.robot;
  std::mt19937_64 random(1);
  MappingScratch scratch;
  const auto value = [&](std::size_t frame, const JointVector& q) {
    scratch.model.reset(q.size());
    add_frame(problem, frame, q, scratch, scratch.model, humanlike::Curvature::none);
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
      if (!(std::abs(value(frame, flipped(flip, q)) - as_is) <= kRelative * std::abs(as_is))) {
        return false;
      }
    }
  }
  return true;
}

/// The least distance from a limit of the joints that differ among twins.
double room(const Twins& twins, const JointVector& q) {
  double least = std::numeric_limits<double>::infinity();
  for (const Index j : joints_of(twins)) {
    least = std::min({least, q[j] - twins.lower[j], twins.upper[j] - q[j]});
  }
  return least;
}

}  // namespace

Twins find_twins(const MappingProblem& problem) {
  const RobotTable& robot = *problem.robot;
  Twins twins{{}, {}, robot.lower, robot.upper};
  for (const Twins::Flip& flip : possible_flips(robot)) {
    if (twins.flips.size() == kMostFlips) break;
    if (leaves_objective(flip, problem)) twins.flips.push_back(flip);
  }
  for (Index j = 0; j < robot.lower.size() && twins.turning.size() < kMostTurning; ++j) {
    if (robot.upper[j] - robot.lower[j] > 2 * pi) twins.turning.push_back(j);
  }
  return twins;
}

std::vector<Index> joints_of(const Twins& twins) {
  std::vector<Index> joints = twins.turning;
  for (const Twins::Flip& flip : twins.flips) {
    joints.insert(joints.end(), {flip.first, flip.middle, flip.last});
  }
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

bool alike(const Twins& twins, const JointVector& a, const JointVector& b, double tolerance) {
  for (const JointVector& twin : all_flipped(twins, b)) {
    double largest = 0;
    for (Index j = 0; j < a.size() && largest < tolerance; ++j) {
      largest = std::max(largest, std::abs(std::remainder(a[j] - twin[j], 2 * pi)));
    }
    if (largest < tolerance) return true;
  }
  return false;
}

std::vector<JointVector> twins_of(const Twins& twins, const JointVector& q) {
  std::vector<JointVector> found;
  for (JointVector twin : all_flipped(twins, q)) {
    const auto turn_inside = [&](Index j) {  // to the first whole turn above the lower limit
      twin[j] -= 2 * pi * std::floor((twin[j] - twins.lower[j]) / (2 * pi));
    };
    for (const Index j : joints_of(twins)) {
      if (twin[j] < twins.lower[j] || twin[j] > twins.upper[j]) turn_inside(j);
    }
    std::ranges::for_each(twins.turning, turn_inside);
    std::vector<JointVector> turned{twin};
    for (const Index j : twins.turning) {
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
                           [&](const JointVector& twin) { return room(twins, twin); });
  return found;
}

}  // namespace morphe::map
