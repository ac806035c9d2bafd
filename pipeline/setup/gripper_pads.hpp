#pragma once

#include <vector>

#include "pipeline/setup/hand_frames.hpp"

namespace morphe::setup {

/// Finds the pads of a gripper's two jaws together, in the posture in which their surfaces touch,
/// or which is the closed end of the range. The normal of a pad is the direction in which its jaw
/// approaches the other one there, z points away from the arm. Without shapes the pads are assumed
/// to meet in the middle between the jaws at the closed end of the range, as far from the palm as
/// the tips in the file, the tool centre point in the file, or twice the centres of mass. Throws
/// InputError if neither shapes nor limits tell the direction of closing.
std::vector<Pad> gripper_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points);

/// Returns the largest distance between the pads of two jaws [m].
double gripper_opening(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads);

}  // namespace morphe::setup
