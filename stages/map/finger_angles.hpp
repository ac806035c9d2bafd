#pragma once

#include <vector>

#include "core/human/hand.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::map {

/// Retargets the joint angles of a human hand to those of a robot's. For each finger it finds the
/// angles inside their limits whose bones point most nearly as the human's do in the palm's frame:
/// the least sum of squared distances between the finger's joints and those of a finger with the
/// robot's bone lengths and the human's directions (humanlike::match_link_directions).
class FingerAngles {
 public:
  /// Prepares the retargeting for a robot's hand.
  explicit FingerAngles(const RobotModel& robot);

  /// Returns the positions of all the robot's joints [n] for the human angles `human` [20]
  /// (kHandAngleNames). They are NaN for the arm and for fingers that have NaN in `human`.
  JointVector operator()(const JointVector& human);

 private:
  /// A finger of the robot and the human finger that it follows.
  struct Finger {
    /// Index of the human finger: 0 is the thumb, otherwise the nearest one.
    std::size_t human = 0;
    /// Share along the curves through the joints of index … little, or NaN.
    double curve_share = 0;
    std::vector<int> frames;   ///< frames of `hand`, the knuckle's first
    std::size_t tip = 0;       ///< tip of `hand`
    humanlike::Chain at_zero;  ///< origins of the frames and the tip, all joints at zero
    std::vector<int> joints;   ///< joints of `hand` that move the finger
  };
  /// Returns the joints of the human finger (or of the curve between fingers) that `finger`
  /// follows.
  humanlike::Chain human_chain(const Finger& finger, const std::vector<Pose>& poses) const;

  std::vector<int> joints;  ///< joints of the robot, indexed by those of `hand`
  RobotModel hand;          ///< the robot's joints beyond the palm, all others at zero
  Eigen::Index robot_joints;
  Pose base_from_palm;  ///< pose of the palm in `hand`
  std::vector<Finger> fingers;
  RobotModel human;        ///< hand of average size: only angles count, not lengths
  JointVector warm_start;  ///< the last solution
};

}  // namespace morphe::map
