#pragma once

#include <vector>

#include "core/human/hand.hpp"
#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/smooth_steps.hpp"

namespace morphe::synthesize {

/// The size of a hand state: kHandAngleNames and palm_arch.
inline constexpr int kHandStateSize = static_cast<int>(kHandAngleCount) + 1;
/// The joint angles of a hand [rad].
using HandState = Eigen::Matrix<double, kHandStateSize, 1>;

/// Converts a state to the angles of the hand.
human::HandAngles hand_angles(const HandState& state);
/// Returns the state of a flat hand.
HandState flat_hand();

/// The postures between which the hand of one person moves. All postures from wide open to closed
/// on a thin object lie on one straight line in joint angles (a synergy), along which thumb and
/// index tip approach each other. The middle finger is never abducted, because gloves do not
/// measure its abduction.
struct HandPostures {
  /// The postures of the person.
  HandState resting, open, closed, pointing;
};
/// Draws typical angles, with each joint varied by about 3 degrees between subjects.
HandPostures draw_hand_postures(const RobotModel& hand, math::RandomStream& random);

/// Returns the distance of thumb and index tip [m].
double aperture(const RobotModel& hand, const HandState& state);
/// Returns the posture between open and closed with the given aperture, or the nearer end if there
/// is no such posture.
HandState posture_of_aperture(const RobotModel& hand, const HandPostures& postures,
                              double aperture_m);

}  // namespace morphe::synthesize
