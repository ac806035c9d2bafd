#pragma once

#include <vector>

#include "core/motion/arm_branch.hpp"
#include "core/motion/robot_model.hpp"
#include "core/robot/arm_axes.hpp"

namespace morphe::robot {

/// The parts of an arm whose singular postures divide its branches, found once from its axes.
struct ArmAnatomy {
  std::vector<int> hinges;  ///< frames from the base to the palm
  /// The hinge that changes the distance of shoulder S and wrist W most, an index of `hinges`; S is
  /// the point of the previous axis nearest to the one before it, W that of the next axis nearest
  /// to the one after it. -1: there is no such hinge, and the arm has one branch.
  int elbow = -1;
  bool spherical_shoulder = false;  ///< the first three axes are inclined in turn, elbow beyond
  bool planar_shoulder = false;     ///< otherwise: the first two are inclined
  /// Sign of shoulder times elbow at which the elbow is up; 0 if its height says nothing.
  int height_sign = 0;
};

/// Returns the whole turns by which a joint with limits lower … upper that moves between `least`
/// and `greatest` [rad] is wound up: its path is clearly farther from zero than the limits require.
int wound_turns(double lower, double upper, double least, double greatest);

/// Derives the anatomy of an arm.
ArmAnatomy find_arm_anatomy(const RobotModel& robot);

/// The factors of the arm's singularities at one posture, in -1 … 1; NaN if the arm lacks one.
///   shoulder: a_1 · (a_2 × a_3) of a spherical shoulder; of another one the side of the wrist's
///             second axis with regard to the plane of the first two axes, (W' - S') · (a_1 × a_2);
///   elbow:    a_e · ((E - S) × (W - E)), 0 if the arm is stretched or folded;
///   wrist:    a_{e+1} · (a_{e+2} × a_{e+3}).
/// Each is divided by the lengths of its vectors.
struct BranchFactors {
  double shoulder = kUnknown, elbow = kUnknown, wrist = kUnknown;
};

/// Computes the factors at a posture, given its poses.
BranchFactors branch_factors(const RobotModel& robot, const ArmAnatomy& anatomy,
                             const std::vector<Pose>& base_from_frame);

/// Returns the branch of a path [N, n]: the sign of each factor is that of its sum over the
/// postures that are not near its singularity. `time` [N] is for the changes along the path [s].
ArmBranch branch_of_path(const RobotModel& robot, const JointRows& position,
                         const std::vector<double>& time);

}  // namespace morphe::robot
