#include "stages/map/finger_angles.hpp"

#include <cmath>

#include "core/humanlike/loads.hpp"
#include "core/humanlike/match_link_directions.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "core/solve/minimise.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/finger_curve.hpp"

namespace morphe::map {
namespace {

constexpr int kBones = 3;                  ///< number of bones of a human finger beyond the palm
constexpr double kAverageStature_m = 1.7;  ///< any stature would do: only angles count

/// Returns the robot with the joints beyond its palm alone; appends their indices to `joints`.
RobotModel extract_hand(const RobotModel& robot, std::vector<int>& joints) {
  RobotModel hand = robot;
  std::vector<int> hand_joint_of(robot.joint_names.size(), -1);
  int count = 0;
  hand.joint_names.clear();
  for (int frame = 0; frame < std::ssize(hand.frames); ++frame) {
    int& joint = hand.frames[frame].joint;
    if (joint < 0 || frame == robot.palm_frame ||
        !robot::is_in_subtree(robot, frame, robot.palm_frame)) {
      joint = -1;
      continue;
    }
    if (hand_joint_of[joint] < 0) {
      hand_joint_of[joint] = count++;
      joints.push_back(joint);
      hand.joint_names.push_back(robot.joint_names[joint]);
    }
    joint = hand_joint_of[joint];
  }
  hand.lower = robot.lower(joints);
  hand.upper = robot.upper(joints);
  return hand;
}

JointVector zero_posture(const RobotModel& robot) { return JointVector::Zero(robot.joints()); }

Vec3 origin(const std::vector<Pose>& poses, int frame) { return poses[frame].translation(); }

/// Returns the last three distinct hinges of a finger, the knuckle first.
std::vector<int> hinges_of(const RobotModel& robot, const std::vector<Pose>& poses, int tip) {
  std::vector<int> hinges;
  Vec3 next_origin = robot::tip_pose(robot, poses, tip).translation();
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame)) {
    if (frame == robot.palm_frame) break;
    if (robot::joint_of(robot, frame) < 0) continue;
    if ((origin(poses, frame) - next_origin).norm() < kCoincidentHinges_m) continue;
    if (hinges.size() == kBones) break;
    next_origin = origin(poses, frame);
    hinges.insert(hinges.begin(), frame);
  }
  return hinges;
}

/// Returns the positions of the finger's joints, its tip last.
humanlike::Chain chain_at(const RobotModel& robot, const std::vector<Pose>& poses,
                          const std::vector<int>& hinges, int tip) {
  humanlike::Chain chain;
  for (const int frame : hinges) chain.push_back(origin(poses, frame));
  chain.push_back(robot::tip_pose(robot, poses, tip).translation());
  return chain;
}

}  // namespace

FingerAngles::FingerAngles(const RobotModel& robot)
    : hand(extract_hand(robot, joints)),
      robot_joints(robot.joints()),
      human(human::human_hand(human::hand_size_of_stature(kAverageStature_m))) {
  std::vector<Pose> poses;
  robot::forward_kinematics(hand, zero_posture(hand), poses);
  base_from_palm = poses[hand.palm_frame];
  for (int tip = 0; tip < std::ssize(hand.tips); ++tip) {
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
  const auto chain_of = [&](int tip) {
    return chain_at(human, poses, hinges_of(human, poses, tip), tip);
  };
  if (!std::isfinite(finger.curve_share)) return chain_of(finger.human);
  const auto index = chain_of(1), middle = chain_of(2), ring = chain_of(3), little = chain_of(4);
  humanlike::Chain interpolated;
  for (int i = 0; i <= kBones; ++i) {
    const std::array<Vec3, 4> finger_points = {index[i], middle[i], ring[i], little[i]};
    interpolated.push_back(finger_curve_point(finger_points, finger.curve_share));
  }
  return interpolated;
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
  problem.model = [&](const JointVector& posture, solve::Quadratic& model) {
    robot::forward_kinematics(hand, posture, poses);
    loads.reset(hand.frames.size(), humanlike::Curvature::gauss_newton);
    for (int k = 0; k < std::ssize(fingers); ++k) {
      const Finger& finger = fingers[k];
      const humanlike::Chain reached_chain = chain_at(hand, poses, finger.frames, finger.tip);
      for (int i = 1; i < std::ssize(reached_chain); ++i) {
        if (!is_known(goals[k][i])) continue;
        const int frame =
            i < std::ssize(finger.frames) ? finger.frames[i] : hand.tips[finger.tip].frame;
        loads.add_point(frame, reached_chain[i], goals[k][i], kFingerPositionWeight_per_m2, true);
      }
    }
    humanlike::add_derivatives(hand, poses, loads, sweep, model);
  };
  warm_start = solve::minimise(problem, warm_start, solve::MinimiseOptions{}).x;

  JointVector angles = JointVector::Constant(robot_joints, kUnknown);
  for (int k = 0; k < std::ssize(fingers); ++k) {
    if (!is_known(goals[k].back())) continue;
    for (const int joint : fingers[k].joints) angles[joints[joint]] = warm_start[joint];
  }
  return angles;
}

}  // namespace morphe::map
