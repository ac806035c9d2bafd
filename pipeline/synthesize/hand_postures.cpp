#include "pipeline/synthesize/hand_postures.hpp"

#include <algorithm>

namespace morphe::synthesize {
namespace {

constexpr std::size_t kMiddleAbduction = 8;

/// kHandAngleNames, palm_arch.
constexpr double kResting[] = {0.35, 0.1, 0.2, 0.25, 0,    0.35, 0.5, 0.2,  0,    0.45, 0.55,
                               0.25, 0,   0.5, 0.6,  0.25, 0,    0.5, 0.55, 0.25, 0.05};
constexpr double kOpen[] = {1.1,  0.55,  0,   0,    0.1,  0.08, 0.12, 0.06, 0,    0.08, 0.14,
                            0.06, -0.05, 0.1, 0.16, 0.06, -0.1, 0.12, 0.16, 0.06, 0.08};
constexpr double kClosed[] = {1.2,  0.25,  0.2,  0.25, 0.07, 0.55,  0.7,  0.35, 0,    0.6, 0.7,
                              0.35, -0.04, 0.65, 0.7,  0.35, -0.08, 0.65, 0.7,  0.35, 0.2};
constexpr double kPointing[] = {0.5, 0.1, 0.3, 0.35, 0,   0.15, 0.2, 0.1,  0,   0.7, 0.9,
                                0.4, 0,   0.8, 0.95, 0.4, 0,    0.8, 0.95, 0.4, 0.08};

HandState varied(const double* typical, const HandState& personal, const RobotTable& hand) {
  HandState state = Eigen::Map<const HandState>(typical) + personal;
  state = state.cwiseMax(hand.lower).cwiseMin(hand.upper);
  state[kMiddleAbduction] = 0;
  return state;
}

}  // namespace

human::HandAngles hand_angles(const HandState& state) {
  human::HandAngles angles;
  std::copy_n(state.data(), kHandAngles, angles.joint.begin());
  angles.palm_arch = state[kHandState - 1];
  return angles;
}

HandState flat_hand() { return HandState::Zero(); }

HandPostures draw_hand_postures(const RobotTable& hand, math::RandomStream& random) {
  constexpr double kPersonal = 0.05;  // [rad]
  HandState personal;
  for (double& joint : personal) joint = kPersonal * random.normal();
  return {varied(kResting, personal, hand), varied(kOpen, personal, hand),
          varied(kClosed, personal, hand), varied(kPointing, personal, hand)};
}

double aperture(const RobotTable& hand, const HandState& state) {
  std::vector<Pose> frames;
  const human::HandPoints points = human::hand_points(hand, hand_angles(state), frames);
  return (points.tip[0] - points.tip[1]).norm();
}

HandState posture_of_aperture(const RobotTable& hand, const HandPostures& postures,
                              double aperture_m) {
  const auto at = [&](double closure) -> HandState {
    return postures.open + closure * (postures.closed - postures.open);
  };
  constexpr int kHalvings = 24;
  double wider = 0, narrower = 1;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (wider + narrower);
    (aperture(hand, at(middle)) > aperture_m ? wider : narrower) = middle;
  }
  return at(0.5 * (wider + narrower));
}

}  // namespace morphe::synthesize
