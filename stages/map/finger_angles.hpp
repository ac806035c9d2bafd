#pragma once

#include <vector>

#include "core/human/hand.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::map {

/// Retargets the joint angles of a human hand to a robot's: those inside the limits that bring the
/// joints of each finger nearest (least sum of squared distances) to a finger with the robot's bone
/// lengths and the human's directions in the palm's frame (humanlike::match_link_directions).
class FingerAngles {
 public:
  /// Prepares the retargeting for a robot's hand.
  explicit FingerAngles(const RobotModel& robot);
  /// Returns the positions [n] of the robot's joints for `human_angles` [20] (kHandAngleNames): NaN
  /// for the arm and for fingers with a NaN angle. Starts from the solution of the previous call.
  JointVector operator()(const JointVector& human_angles);

 private:
  /// A finger of the robot and the human finger that it follows.
  struct Finger {
    int human = 0;             ///< the human finger, or the one nearest to `curve_share`
    double curve_share = 0;    ///< share of the length of the curve from index to little, or NaN
    std::vector<int> frames;   ///< frames of `hand`, the knuckle's first
    int tip = 0;               ///< tip of `hand`
    humanlike::Chain at_zero;  ///< origins of the frames and the tip, all joints at zero
    std::vector<int> joints;   ///< joints of `hand` that move the finger
  };
  /// Returns the joint positions of the human finger, or curve between fingers, to be followed.
  humanlike::Chain human_chain(const Finger& finger, const std::vector<Pose>& poses) const;

  std::vector<int> joints;  ///< joints of the robot, indexed by those of `hand`
  RobotModel hand;          ///< the robot's joints beyond the palm, all others at zero
  Eigen::Index robot_joints;
  Pose base_from_palm;  ///< pose of the palm of `hand` in its base
  std::vector<Finger> fingers;
  RobotModel human;        ///< hand of average size: only its angles count, not its lengths
  JointVector warm_start;  ///< the last solution
};

}  // namespace morphe::map
