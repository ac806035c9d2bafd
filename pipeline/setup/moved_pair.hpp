#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "pipeline/setup/link_bodies.hpp"

namespace morphe::setup {

inline constexpr double kTouch_m = 1e-5;  ///< shapes as near as this touch: rounding of files
/// A linkage's bars that are at most so far apart can hardly keep a margin of 1 mm.
inline constexpr double kLinkagePlay_m = 0.0015;

/// Two bodies, and the joints that move them relative to each other.
struct MovedPair {
  const RobotModel& robot;
  int first, second;  ///< frames
  const LinkBody &one, &other;
  std::vector<int> joints = {};
  RobotModel branch = {};            ///< the frames that move them, from their last common one on
  int one_end = -1, other_end = -1;  ///< their frames in `branch`; -1 = the common one
  std::vector<Pose> poses = {};

  Pose one_from_other(const JointVector& q);
  double gap_m(const JointVector& q);
  bool touch(const JointVector& q);
  double depth_m(const JointVector& q);
};
/// Returns the joints that move two frames relative to each other.
std::vector<int> joints_between(const RobotModel& robot, int one, int other);
/// Returns the pair of two frames of `bodies`, `robot` and `bodies` must outlive it.
MovedPair moved_pair(const RobotModel& robot, const LinkBodies& bodies, int first, int second);

/// Returns true if the pair's only joint moves both bodies, as in a mechanism.
bool moved_by_one_joint(const MovedPair& pair);

/// The result of following a pair's only joint from limit to limit, the others at `q`.
struct JointSweep {
  bool holds = false;      ///< true in all postures that were tested
  bool proven = false;     ///< true if bounds on the motion prove it between them, too
  int postures = 0;        ///< number of postures that were tested
  double least_gap_m = 0;  ///< of keeps_apart(): no distance of the bodies is below it
};
/// Follows the joint while the bodies overlap, in steps within which the deepest point cannot leave
/// the other body. Steps that would be too many are longer, and then nothing is proved between
/// them.
JointSweep keeps_overlapping(MovedPair& pair, JointVector q);
/// Proves that the bodies never touch: between two postures, b - a of the joint apart, the distance
/// is at least (d_a + d_b - lever (b - a)) / 2, and intervals are halved until this is at most 2 %
/// below the least distance that was measured. It does not hold if it cannot be proved.
JointSweep keeps_apart(MovedPair& pair, JointVector q);
/// Tests that the bodies never part by more than the play of a linkage.
JointSweep keeps_together(MovedPair& pair, JointVector q);

}  // namespace morphe::setup
