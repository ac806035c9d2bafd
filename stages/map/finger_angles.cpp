#include "stages/map/finger_angles.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/loads.hpp"
#include "core/humanlike/match_link_directions.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "core/solve/minimise.hpp"
#include "stages/map/finger_curve.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;
constexpr std::size_t kBones = 3;             ///< number of bones of a human finger beyond the palm
constexpr double kCoincidentHinges_m = 1e-6;  ///< distance below which two hinges coincide [m]
constexpr double kStature_m = 1.7;            ///< [m]

/// Returns the robot with only the joints beyond its palm, listed in `joints`.
RobotModel extract_hand(const RobotModel& robot, std::vector<int>& joints) {
  RobotModel hand = robot;
  for (std::size_t i = 0; i < hand.frames.size(); ++i) {
    int& joint = hand.frames[i].joint;
    const auto frame = static_cast<int>(i);
    if (joint < 0 || frame == robot.palm_frame ||
        !robot::is_in_subtree(robot, frame, robot.palm_frame)) {
      joint = -1;
      continue;
    }
    auto known = std::ranges::find(joints, joint);
    if (known == joints.end()) known = joints.insert(known, joint);
    joint = static_cast<int>(known - joints.begin());
  }
  hand.joint_names.clear();
  hand.lower.resize(joints.size());
  hand.upper.resize(hand.lower.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const int of = joints[j];
    hand.joint_names.push_back(robot.joint_names[of]);
    hand.lower[j] = robot.lower[of];
    hand.upper[j] = robot.upper[of];
  }
  return hand;
}

JointVector zero_posture(const RobotModel& robot) { return JointVector::Zero(robot.joints()); }

Vec3 origin(const std::vector<Pose>& poses, int frame) { return poses[frame].translation(); }

/// Returns the last three distinct hinges of a finger, the knuckle first.
std::vector<int> hinges_of(const RobotModel& robot, const std::vector<Pose>& poses,
                           std::size_t tip) {
  std::vector<int> hinges;
  Vec3 beyond = robot::tip_pose(robot, poses, tip).translation();
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame)) {
    if (frame == robot.palm_frame) break;
    if (robot::joint_of(robot, frame) < 0) continue;
    if ((origin(poses, frame) - beyond).norm() < kCoincidentHinges_m) continue;
    if (hinges.size() == kBones) break;
    beyond = origin(poses, frame);
    hinges.insert(hinges.begin(), frame);
  }
  return hinges;
}

/// Returns the positions of the finger's joints, its tip last.
humanlike::Chain chain_at(const RobotModel& robot, const std::vector<Pose>& poses,
                          const std::vector<int>& hinges, std::size_t tip) {
  humanlike::Chain chain;
  for (const int frame : hinges) chain.push_back(origin(poses, frame));
  chain.push_back(robot::tip_pose(robot, poses, tip).translation());
  return chain;
}

}  // namespace

FingerAngles::FingerAngles(const RobotModel& robot)
    : hand(extract_hand(robot, joints)),
      robot_joints(robot.joints()),
      human(human::human_hand(human::hand_size_of_stature(kStature_m))) {
  std::vector<Pose> poses;
  robot::forward_kinematics(hand, zero_posture(hand), poses);
  base_from_palm = poses[hand.palm_frame];
  for (std::size_t tip = 0; tip < hand.tips.size(); ++tip) {
    if (hand.tips[tip].finger < 0) continue;
    Finger finger;
    finger.human = hand.tips[tip].finger;
    finger.curve_share = hand.tips[tip].finger_curve_share;
    finger.frames = hinges_of(hand, poses, tip);
    finger.tip = tip;
    finger.at_zero = chain_at(hand, poses, finger.frames, tip);
    for (const int frame : robot::ancestors(hand, hand.tips[tip].frame)) {
      const int joint = robot::joint_of(hand, frame);
      if (joint >= 0) finger.joints.push_back(joint);
    }
    if (!finger.frames.empty()) fingers.push_back(std::move(finger));
  }
  warm_start = zero_posture(hand).cwiseMax(hand.lower).cwiseMin(hand.upper);
}

humanlike::Chain FingerAngles::human_chain(const Finger& finger,
                                           const std::vector<Pose>& poses) const {
  const auto of = [&](std::size_t k) {
    return chain_at(human, poses, hinges_of(human, poses, k), k);
  };
  if (!std::isfinite(finger.curve_share)) return of(finger.human);
  const std::array<humanlike::Chain, 4> four = {of(1), of(2), of(3), of(4)};
  humanlike::Chain between;
  for (std::size_t i = 0; i <= kBones; ++i) {
    between.push_back(
        finger_curve_point({four[0][i], four[1][i], four[2][i], four[3][i]}, finger.curve_share));
  }
  return between;
}

JointVector FingerAngles::operator()(const JointVector& human_angles) {
  std::vector<Pose> poses;
  JointVector q = zero_posture(human);
  q.head(human_angles.size()) = human_angles;
  robot::forward_kinematics(human, q, poses);
  std::vector<humanlike::Chain> goals;
  for (const Finger& finger : fingers) {
    humanlike::Chain chain = human_chain(finger, poses);
    for (Vec3& joint : chain) {
      if (hand.side == Side::left) joint.y() = -joint.y();
      joint = base_from_palm * joint;
    }
    goals.push_back(humanlike::match_link_directions(chain, finger.at_zero));
  }

  solve::BoundedProblem problem;
  problem.lower = hand.lower;
  problem.upper = hand.upper;
  humanlike::Loads loads;
  humanlike::LoadSweep sweep;
  problem.model = [&](const JointVector& at, solve::Quadratic& model) {
    constexpr double kPositionWeight = 1e4;  // per m²: a centimetre counts as one
    robot::forward_kinematics(hand, at, poses);
    loads.reset(hand.frames.size(), humanlike::Curvature::gauss_newton);
    for (std::size_t k = 0; k < fingers.size(); ++k) {
      const Finger& finger = fingers[k];
      const humanlike::Chain reached = chain_at(hand, poses, finger.frames, finger.tip);
      for (std::size_t i = 1; i < reached.size(); ++i) {
        if (!is_known(goals[k][i])) continue;
        const int frame = i < finger.frames.size() ? finger.frames[i] : hand.tips[finger.tip].frame;
        loads.add_point(frame, reached[i], goals[k][i], kPositionWeight, true);
      }
    }
    humanlike::add_derivatives(hand, poses, loads, sweep, model);
  };
  warm_start = solve::minimise(problem, warm_start, solve::MinimiseOptions{}).x;

  JointVector angles = JointVector::Constant(robot_joints, kUnknown);
  for (std::size_t k = 0; k < fingers.size(); ++k) {
    if (!is_known(goals[k].back())) continue;
    for (const int joint : fingers[k].joints) {
      angles[joints[joint]] = warm_start[joint];
    }
  }
  return angles;
}

}  // namespace morphe::map
