#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"
#include "core/robot/pads.hpp"

namespace morphe::robot {

/// A robot: its table, and what follows from frames, tips, centres and capsules, derived once. It
/// is const and shared by all threads; scratch is each thread's own. Limits may be
/// changed afterwards: nothing else follows from them, but for those of joints that slide, which
/// may only be narrowed.
struct Robot : RobotTable {
  Robot() = default;
  explicit Robot(RobotTable table);

  /// [frames] the nearest frame at or above it that a joint turns, -1 if none does.
  std::vector<int> moving_frame;
  std::vector<int> arm_joints;   ///< those that move the palm, in order
  std::vector<int> arm_centres;  ///< frames of the arm's joint centres, in order
  std::vector<int>
      tip_of_centre;      ///< [centres] the tip of the finger it moves; -1: none's, or the arm's
  std::vector<Pad> pads;  ///< [tips]
  std::vector<double> centres_of_chain;  ///< [centres] how many its chain has
  /// [capsules, n] how far any point of a capsule can travel per radian (metre, if it slides) of
  /// each joint [m], see levers.hpp.
  JointRows capsule_levers;
};

/// Positions of the arm's joint centres (metric A), given the frames' poses [m].
std::vector<Vec3> arm_centre_positions(const Robot& robot,
                                       const std::vector<Pose>& base_from_frame);

}  // namespace morphe::robot
