#pragma once

#include "core/human/hand.hpp"
#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/smooth_steps.hpp"

namespace morphe::synthesize {

inline constexpr int kHandStateSize = kHandAngleCount + 1;
/// The joint angles of a hand, kHandAngleNames and palm_arch [rad].
using HandState = Eigen::Matrix<double, kHandStateSize, 1>;

/// Converts a state to the angles of the hand.
human::HandAngles hand_angles(const HandState& state);
/// Returns the state of a flat hand.
HandState flat_hand();

/// The postures of one person's hand. Between `open` and `closed` (on a thin object), it moves
/// along a line in joint angles (a synergy). The middle finger is not abducted: no glove measures
/// that.
struct HandPostures {
  HandState resting, open, closed, pointing;
};
/// Draws the postures of a person: typical angles, to which the person adds a normally distributed
/// angle of each joint (standard deviation 0.05 rad).
HandPostures draw_hand_postures(const RobotModel& hand, math::RandomStream& random);

/// Returns the distance of thumb and index tip [m].
double aperture(const RobotModel& hand, const HandState& state);
/// Returns the posture between open and closed with an aperture, or that of the two with the nearer
/// one.
HandState posture_of_aperture(const RobotModel& hand, const HandPostures& postures,
                              double aperture_m);

}  // namespace morphe::synthesize
