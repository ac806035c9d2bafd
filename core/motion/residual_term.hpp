#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe {

/// The robot in one frame of a movement, and what the frame asks of it, in the robot's base frame.
/// What was not seen is NaN.
class Posture {
 public:
  const RobotTable& robot;
  const JointVector& q;                      ///< [n] [rad]
  const std::vector<Pose>& base_from_frame;  ///< of each of the robot's frames
  const std::vector<Vec3>& tip_goal;         ///< for each of the robot's tips [m]
  const Vec3 &shoulder, &elbow, &wrist;      ///< of the human arm, moved to the robot's [m]

  /// [3, n] d point / d q of a point that moves with a frame [m/rad].
  virtual Eigen::Matrix3Xd point_jacobian(int frame, const Vec3& point_in_base) const = 0;

 protected:
  Posture(const RobotTable& of, const JointVector& at, const std::vector<Pose>& frames,
          const std::vector<Vec3>& goal, const Vec3& human_shoulder, const Vec3& human_elbow,
          const Vec3& human_wrist)
      : robot(of),
        q(at),
        base_from_frame(frames),
        tip_goal(goal),
        shoulder(human_shoulder),
        elbow(human_elbow),
        wrist(human_wrist) {}
  ~Posture() = default;
};

/// A term of the objective that a program brings along: weight times the sum of squares of its
/// residuals r(q), frame by frame. Where it stands in the objective, and its weight, the config
/// says: `map.terms: [{name: ..., weight: ...}]`. The mapping takes 2 Jᵀr for its gradient and
/// 2 JᵀJ for its curvature, so J must be right: compare it with finite differences.
class ResidualTerm {
 public:
  virtual ~ResidualTerm() = default;
  virtual std::string name() const = 0;
  /// Sets r [k] and J [k, n] = d r / d q; k may be another in every frame, also 0. Several threads
  /// call it at once, and the result must depend on the posture alone.
  virtual void residuals(const Posture& posture, JointVector& r, JointRows& jacobian) const = 0;
};

}  // namespace morphe
