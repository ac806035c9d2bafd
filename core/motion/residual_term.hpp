#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe {

/// The robot's posture in one frame of a movement, and the goals of this frame, in the robot's base
/// frame. Values that were not observed are NaN.
class ResidualInput {
 public:
  const RobotModel& robot;
  const JointVector& q;                      ///< [n] [rad]
  const std::vector<Pose>& base_from_frame;  ///< poses of the robot's frames
  const std::vector<Vec3>& tip_goal;         ///< goals of the robot's tips [m]
  /// Points of the human arm, moved to the robot's shoulder [m].
  const Vec3 &shoulder, &elbow, &wrist;

  /// Returns the Jacobian d point / d q, [3, n] [m/rad], of a point that moves with a frame.
  virtual Eigen::Matrix3Xd point_jacobian(int frame, const Vec3& point_in_base) const = 0;

 protected:
  ResidualInput(const RobotModel& model, const JointVector& position,
                const std::vector<Pose>& frames, const std::vector<Vec3>& goals,
                const Vec3& human_shoulder, const Vec3& human_elbow, const Vec3& human_wrist)
      : robot(model),
        q(position),
        base_from_frame(frames),
        tip_goal(goals),
        shoulder(human_shoulder),
        elbow(human_elbow),
        wrist(human_wrist) {}
  ~ResidualInput() = default;
};

/// A term of the objective that the calling program provides: weight times the sum of squares of
/// its residuals r(q), evaluated for each frame. Its position in the objective and its weight are
/// set in the config: `map.custom_terms: [{name: ..., weight: ...}]`. The mapping uses 2 Jᵀr as its
/// gradient and 2 JᵀJ as its Hessian, so J must be correct: compare it with finite differences.
class ResidualTerm {
 public:
  virtual ~ResidualTerm() = default;
  /// Returns the name under which the config refers to the term.
  virtual std::string name() const = 0;
  /// Sets r [k] and J [k, n] = d r / d q. k may differ from frame to frame and may be 0. Several
  /// threads call this function concurrently, and the result must depend only on the input.
  virtual void residuals(const ResidualInput& input, JointVector& r, JointRows& jacobian) const = 0;
};

}  // namespace morphe
