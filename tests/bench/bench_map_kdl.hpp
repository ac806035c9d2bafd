#pragma once

#include "core/motion/robot_model.hpp"

namespace morphe {

/// KDL's Newton–Raphson with joint limits (ChainIkSolverPos_NR_JL) on an arm of one chain, its only
/// tip the wrist's.
class KdlArm {
 public:
  explicit KdlArm(const RobotModel& robot);
  ~KdlArm();
  /// Steps from q towards the tip's pose; false if it did not arrive.
  bool solve(const Pose& base_from_tip, JointVector& q);

 private:
  struct Solver;
  Solver* solver_;
};

}  // namespace morphe
