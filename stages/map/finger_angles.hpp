#pragma once

#include <vector>

#include "core/human/hand.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::map {

/// Turns the angles of a human hand into those of a robot's: of each finger the angles, inside
/// their limits, whose bones point most nearly as the human's do in the palm's frame (least sum of
/// squared distances between the finger's joints and those of one that is posed_like the human's).
class FingerAngles {
 public:
  explicit FingerAngles(const RobotTable& robot);

  /// Angles of all the robot's joints [n]; NaN: of the arm, and of fingers that have NaN in `human`
  /// [20] (kHandAngleNames).
  JointVector operator()(const JointVector& human);

 private:
  struct Finger {
    std::size_t human = 0;     ///< 0 the thumb; others: the nearest
    double along = 0;          ///< of the curves through the joints of index … little, or NaN
    std::vector<int> frames;   ///< of `hand`, the knuckle's first
    std::size_t tip = 0;       ///< of `hand`
    humanlike::Chain at_zero;  ///< the frames' origins and the tip
    std::vector<int> joints;   ///< of `hand` that move it
  };
  humanlike::Chain human_chain(const Finger& finger, const std::vector<Pose>& poses) const;

  std::vector<int> joints;  ///< of the robot, by those of `hand`
  RobotTable hand;          ///< the robot's joints beyond the palm, all others at zero
  Eigen::Index robot_joints;
  Pose base_from_palm;  ///< of `hand`
  std::vector<Finger> fingers;
  RobotTable human;   ///< of average size: angles count, not lengths
  JointVector start;  ///< the last answer
};

}  // namespace morphe::map
