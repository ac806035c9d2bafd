#pragma once

#include <vector>

#include "core/human/hand.hpp"
#include "core/math/random_stream.hpp"
#include "pipeline/synthesize/smooth_steps.hpp"

namespace morphe::synthesize {

inline constexpr int kHandState =
    static_cast<int>(kHandAngles) + 1;                   ///< kHandAngleNames, palm_arch
using HandState = Eigen::Matrix<double, kHandState, 1>;  ///< [rad]

human::HandAngles hand_angles(const HandState& state);
HandState flat_hand();

/// The postures that one person's hand goes between: everything from wide open to closed on a thin
/// thing lies on one straight line of joint angles (a synergy), along which thumb and index tip
/// approach each other. The middle finger is never abducted: no glove sees that.
struct HandPostures {
  HandState resting, open, closed, pointing;
};
/// Typical angles, each joint changed by about 3 degrees from one subject to the next.
HandPostures draw_hand_postures(const RobotTable& hand, math::RandomStream& random);

/// Distance of thumb and index tip [m].
double aperture(const RobotTable& hand, const HandState& state);
/// The posture between open and closed with this aperture; the nearer end if there is none.
HandState posture_of_aperture(const RobotTable& hand, const HandPostures& postures,
                              double aperture_m);

}  // namespace morphe::synthesize
