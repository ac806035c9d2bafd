#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"
#include "pipeline/setup/link_bodies.hpp"

namespace morphe::setup {

/// A pair of bodies as made: with all joints at rest, and in the postures of the joints between
/// them.
struct LinkPair {
  int first = -1, second = -1;  ///< frames; -1 is the base
  double rest_depth_m = 0;      ///< by which the bodies overlap at rest
  double rest_gap_m = 0;        ///< by which they are apart at rest, 0 if they overlap
  /// Lower bound of their distance over the whole range of their only joint, 0 if not proved.
  double least_gap_m = 0;
  bool excused = false;  ///< true if they overlap by design, or can never touch
  bool linkage = false;  ///< true if they are excused as bars of one mechanism
  bool proven = false;   ///< true if bounds on the motion prove it for all postures
  int postures = 0;      ///< number of postures that were tested
  int joints_between = 0;
  bool assumed = false;  ///< true if capsules stand for the shapes of one of them
};

/// Judges the pairs of bodies that `robot` checks, by their shapes. Two bodies are excused if they
/// overlap at rest and
///   - in all postures of the joints between them: for one joint by steps so small that the deepest
///     point of the overlap cannot leave the other body, which is a proof, or else in 4000 random
///     postures and at all limits, from a fixed seed for each pair; or
///   - one joint moves both, each in its own way, and they never part by more than 1.5 mm, like the
///     bars of a gripper, whose loop a URDF cuts open.
/// Two bodies that are apart at rest are excused if one joint alone moves them relative to each
/// other, and bounds on the motion prove that they never touch within its limits: no plan can bring
/// them nearer, so that a margin would only forbid a part of the joint's range.
/// Bodies within 0.01 mm count as overlapping. All other pairs remain checked.
std::vector<LinkPair> judge_pairs(const RobotModel& robot, const LinkBodies& bodies);

/// Returns the pair's least distance, rounded down to 0.01 mm.
std::string least_distance_text(const LinkPair& pair);

/// Returns the key `allowed_links` of a description with the excused pairs, "" if there are none.
std::string allowed_links_yaml(const std::vector<LinkPair>& pairs,
                               const std::function<std::string(int)>& name_of_frame);

}  // namespace morphe::setup
