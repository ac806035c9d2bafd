#pragma once

#include <string>
#include <vector>

#include "pipeline/humanlike/frame_goal.hpp"
#include "pipeline/humanlike/loads.hpp"
#include "pipeline/humanlike/metrics.hpp"
#include "pipeline/solve/quadratic.hpp"

namespace morphe::humanlike {

/// Where the robot is: what every term of a frame's objective reads.
struct RobotState {
  const RobotTable& robot;
  const JointVector& q;  ///< [n] joints, or [n + 3] with a free offset
  const std::vector<Pose>& base_from_frame;
  Vec3 offset = Vec3::Zero();  ///< free offset, added to every position goal [m]
};

/// Each term adds its value and its pull on the robot's frames (gradient and curvature), times its
/// weight and the goal's share of it. Goals that are NaN add nothing.

/// Eq. (1): sum over tips of ‖x(q) - x_goal‖² [m²].
struct TipPosition {
  double weight = 1000;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Eqs. (2), (3): acos|⟨h, g⟩| of the tips' orientations, half the rotation angle, not squared;
/// smoothed at its kink to sqrt(d² + smoothing²).
struct TipOrientation {
  double weight = 0.01;
  double smoothing_rad = 1e-3;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// The same distance for the hand's orientation: a weak goal where fewer than three tips are seen.
struct HandOrientation {
  double weight = 0.01;
  double smoothing_rad = 1e-3;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Humanlikeness A of the arm, Eq. (5): sum_j ‖s_elbow - s_j‖² over the k joint centres, divided by
/// k so that the weight means the same for every robot [m²].
struct JointDistance {
  double weight = 1;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Humanlikeness A of the fingers, second sum of Eq. (16): ‖s_middle - s_j‖² for each finger whose
/// human middle joint was seen, divided by the number of centres of that finger [m²]. A centre's
/// finger is that of the tip which it moves; a tip between the human's fingers (`along`) has the
/// point of the curve through their middle joints.
struct FingerJointDistance {
  double weight = 1;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Humanlikeness B of the arm, Eq. (6) [m²], see triangle_area_sum; rounded off where a triangle
/// vanishes.
struct TriangleArea {
  double weight = 0;
  double smoothing_m2 = 1e-6;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Humanlikeness C of the arm, Eqs. (7)–(9) [m³], see hull_volume_sum: without a curvature of its
/// own.
struct HullVolume {
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Natural posture of what no goal asks for: sum of (q_joint - q_follow - value)² over joints that
/// move only tips without a goal in this frame [rad²].
struct NaturalPosture {
  struct Joint {
    int joint = 0;
    int follow = -1;        ///< joint to copy, -1 = none
    double value = 0;       ///< [rad]
    std::vector<int> tips;  ///< tips that the joint moves
  };
  double weight = 1e-3;
  std::vector<Joint> joints;
  void add(const RobotState& state, const FrameGoal& goal, solve::Quadratic& model) const;
  /// Root mean square distance from the natural posture over the active joints [rad]; NaN if none.
  double distance(const JointVector& q, const FrameGoal& goal) const;
};

/// Joint-to-joint, the arm: sum over the joints of arm_chain() beyond the shoulder of
/// ‖s_j - goal_j‖² [m²]. No term of the paper's objective.
struct ChainPosition {
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, Loads& loads) const;
};

/// Joint-to-joint, the fingers: sum of (q_j - goal_j)² over the joints that have a goal [rad²].
struct JointAngle {
  double weight = 0;
  void add(const RobotState& state, const FrameGoal& goal, solve::Quadratic& model) const;
};

/// Section 3.3: where the robot's base (a hand's: its wrist) stands beside the human's is part of
/// the search: three more variables, an offset o in the base frame [m] that moves every position
/// goal. weight * ‖o‖² keeps it small; |o_k| <= limit_m.
struct FreeOffset {
  bool free = false;
  double weight = 1;
  double limit_m = 0.1;
  void add(const RobotState& state, solve::Quadratic& model) const;
};

/// The robot's arm as metrics B and C see it, from the shoulder outwards: shoulder, joint centres
/// and the wrist's tip, if there is one; and the frames that the joints move with.
struct ArmChain {
  Chain joints;
  std::vector<int> frames;
};
ArmChain arm_chain(const RobotTable& robot, const std::vector<Pose>& base_from_frame);

}  // namespace morphe::humanlike
