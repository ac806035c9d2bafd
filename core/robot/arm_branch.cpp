#include "core/robot/arm_branch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

/// Distance of shoulder and wrist from the elbow's axis, above which it is an elbow [m]. Chosen by
/// hand: offsets of wrists are below 0.1 m, but their product is far below that of two long links.
constexpr double kMinLever_m = 0.01;
/// Factor below which a posture is too near a singularity to decide: 3 degrees, by hand.
constexpr double kUndecidedFactor = 0.05;
/// Postures of a path that are looked at; 200 are 13 ms apart in a movement of 2.7 s.
constexpr Eigen::Index kMaxPostures = 200;
/// A joint is wound up if whole turns bring the middle of its path nearer to zero by more [rad].
/// Chosen by hand: a path about π has two representatives that are about as good.
constexpr double kMinUnwinding_rad = 1;

/// A part of the arm and the words for a factor that is positive and negative.
struct BranchPart {
  std::string_view name, positive, negative;
  double BranchFactors::*factor;
};
constexpr std::array<BranchPart, 3> kParts{
    {{"shoulder", "right", "left", &BranchFactors::shoulder},
     {"elbow", "positive", "negative", &BranchFactors::elbow},
     {"wrist", "unflipped", "flipped", &BranchFactors::wrist}}};
constexpr BranchPart kElbowHeight{"elbow", "up", "down", &BranchFactors::elbow};

/// The vectors from an axis to the points before and after it whose distance it changes.
struct ElbowLevers {
  Vec3 shoulder, wrist;
};

ElbowLevers elbow_levers(const ArmAxes& axes, int hinge) {
  const Vec3 shoulder = foot_point(axes, hinge - 1, hinge - 2, hinge);
  const Vec3 wrist =
      hinge + 1 < axes.count() ? foot_point(axes, hinge + 1, hinge + 2, hinge) : axes.palm;
  return {lever_from_axis(axes, hinge, shoulder), lever_from_axis(axes, hinge, wrist)};
}

int find_elbow(const ArmAxes& axes) {
  int elbow = -1;
  double longest = 0;
  for (int k = 1; axes.count() > 2 && k < axes.count(); ++k) {
    const ElbowLevers levers = elbow_levers(axes, k);
    const double before = levers.shoulder.norm(), after = levers.wrist.norm();
    if (std::min(before, after) < kMinLever_m || before * after <= longest) continue;
    longest = before * after;
    elbow = k;
  }
  return elbow;
}

double side_of_wrist(const ArmAxes& axes, int elbow) {
  const int wrist = std::min(elbow + 2, axes.count() - 2);
  const Vec3 away = foot_point(axes, wrist, wrist + 1, -1) - foot_point(axes, 0, 1, -1);
  return away.normalized().dot(axes.direction[0].cross(axes.direction[1]).normalized());
}

/// Returns the sign of the sum of the factors that are not near zero; 0 if all of them are.
int path_sign(const std::vector<BranchFactors>& path, double BranchFactors::*factor) {
  double sum = 0;
  for (const BranchFactors& at : path) {  // comparing with NaN is false
    if (std::abs(at.*factor) >= kUndecidedFactor) sum += at.*factor;
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

/// A part with the words that hold on a path, for the sign of its factor times `orientation`.
struct NamedPart {
  BranchPart part;
  int orientation = 1;

  std::string_view word(int sign) const {
    return sign == 0 ? "undecided" : sign * orientation > 0 ? part.positive : part.negative;
  }
};

/// Returns the parts that the arm has.
std::vector<NamedPart> named_parts(const ArmAnatomy& anatomy,
                                   const std::vector<BranchFactors>& path) {
  const int height = anatomy.height_sign * path_sign(path, &BranchFactors::shoulder);
  std::vector<NamedPart> parts;
  for (const BranchPart& part : kParts) {
    if (std::isnan(path.front().*part.factor)) continue;
    if (part.factor == kElbowHeight.factor && height != 0) {
      parts.push_back({kElbowHeight, height});
    } else {
      parts.push_back({part});
    }
  }
  return parts;
}

void add_changes(const NamedPart& named, const std::vector<BranchFactors>& path,
                 const std::vector<double>& time, std::vector<std::string>& changes) {
  int last = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double factor = path[k].*named.part.factor;
    if (!(std::abs(factor) >= kUndecidedFactor)) continue;
    const int sign = factor > 0 ? 1 : -1;
    if (last != 0 && sign != last)
      changes.push_back(fmt::format("{} {} -> {} at {:.2f} s", named.part.name, named.word(last),
                                    named.word(sign), time[k]));
    last = sign;
  }
}

void add_whole_turns(const RobotModel& robot, const ArmAnatomy& anatomy, const JointRows& position,
                     std::vector<std::string>& words) {
  std::set<int> joints;
  for (const int frame : anatomy.hinges) {
    const int joint = robot.frames[frame].joint;
    if (!joints.insert(joint).second) continue;  // it moves a coupled frame, too
    const auto path = position.col(joint);
    const int turns =
        wound_turns(robot.lower[joint], robot.upper[joint], path.minCoeff(), path.maxCoeff());
    if (turns != 0)
      words.push_back(fmt::format("{} wound up by {:+d} turn{}", robot.joint_names[joint], turns,
                                  std::abs(turns) == 1 ? "" : "s"));
  }
}

int branch_number(const std::vector<BranchFactors>& path) {
  int number = 0, bit = 1;
  for (const BranchPart& part : kParts) {
    if (path_sign(path, part.factor) < 0) number += bit;
    bit *= 2;
  }
  return number;
}

}  // namespace

int wound_turns(double lower, double upper, double least, double greatest) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double middle = (least + greatest) / 2;
  int turns = static_cast<int>(std::round(middle / kTurn));
  while (turns != 0 && (least - turns * kTurn < lower || greatest - turns * kTurn > upper))
    turns -= turns > 0 ? 1 : -1;
  const double nearer = std::abs(middle) - std::abs(middle - turns * kTurn);
  return nearer > kMinUnwinding_rad ? turns : 0;
}

ArmAnatomy find_arm_anatomy(const RobotModel& robot) {
  ArmAnatomy anatomy;
  anatomy.hinges = arm_hinges(robot);
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, JointVector::Zero(robot.lower.size()), base_from_frame);
  const ArmAxes axes = arm_axes(robot, anatomy.hinges, base_from_frame);
  anatomy.elbow = find_elbow(axes);
  anatomy.spherical_shoulder = anatomy.elbow > 2 && !std::isnan(triple_product(axes, 1));
  anatomy.planar_shoulder =
      !anatomy.spherical_shoulder && anatomy.elbow > 1 && are_inclined(axes, 0, 1);
  if (anatomy.planar_shoulder && anatomy.elbow == 2 && !are_inclined(axes, 1, 2))
    anatomy.height_sign = axes.direction[1].dot(axes.direction[2]) > 0 ? -1 : 1;
  return anatomy;
}

BranchFactors branch_factors(const RobotModel& robot, const ArmAnatomy& anatomy,
                             const std::vector<Pose>& base_from_frame) {
  BranchFactors factors;
  if (anatomy.elbow < 0) return factors;
  const ArmAxes axes = arm_axes(robot, anatomy.hinges, base_from_frame);
  if (anatomy.spherical_shoulder) factors.shoulder = triple_product(axes, 1);
  if (anatomy.planar_shoulder) factors.shoulder = side_of_wrist(axes, anatomy.elbow);
  const ElbowLevers levers = elbow_levers(axes, anatomy.elbow);
  factors.elbow = axes.direction[anatomy.elbow].dot(
      levers.wrist.normalized().cross(levers.shoulder.normalized()));
  factors.wrist = triple_product(axes, anatomy.elbow + 2);
  return factors;
}

ArmBranch branch_of_path(const RobotModel& robot, const JointRows& position,
                         const std::vector<double>& time) {
  ArmBranch branch;
  const ArmAnatomy anatomy = find_arm_anatomy(robot);
  const Eigen::Index rows = position.rows();
  if (rows == 0 || anatomy.elbow < 0) return branch;
  std::vector<BranchFactors> path;
  std::vector<double> path_time;
  std::vector<Pose> base_from_frame;
  const Eigen::Index postures = std::min(rows, kMaxPostures);
  for (Eigen::Index k = 0; k < postures; ++k) {
    const Eigen::Index row = postures > 1 ? k * (rows - 1) / (postures - 1) : 0;
    forward_kinematics(robot, position.row(row).transpose(), base_from_frame);
    path.push_back(branch_factors(robot, anatomy, base_from_frame));
    path_time.push_back(time[row]);
  }
  branch.number = branch_number(path);
  for (const NamedPart& named : named_parts(anatomy, path)) {
    branch.words.push_back(
        fmt::format("{} {}", named.part.name, named.word(path_sign(path, named.part.factor))));
    add_changes(named, path, path_time, branch.changes);
  }
  add_whole_turns(robot, anatomy, position, branch.words);
  return branch;
}

}  // namespace morphe::robot
