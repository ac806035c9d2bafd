#include "pipeline/synthesize/hand_postures.hpp"

#include <algorithm>

namespace morphe::synthesize {
namespace {

constexpr std::size_t kMiddleAbduction = 8;

/// Typical postures: kHandAngleNames, palm_arch.
constexpr double kRestingAngles_rad[] = {0.35, 0.1,  0.2,  0.25, 0,    0.35, 0.5,
                                         0.2,  0,    0.45, 0.55, 0.25, 0,    0.5,
                                         0.6,  0.25, 0,    0.5,  0.55, 0.25, 0.05};
constexpr double kOpenAngles_rad[] = {1.1,  0.55, 0,    0,    0.1,  0.08,  0.12,
                                      0.06, 0,    0.08, 0.14, 0.06, -0.05, 0.1,
                                      0.16, 0.06, -0.1, 0.12, 0.16, 0.06,  0.08};
constexpr double kClosedAngles_rad[] = {1.2,  0.25, 0.2,   0.25, 0.07, 0.55,  0.7,
                                        0.35, 0,    0.6,   0.7,  0.35, -0.04, 0.65,
                                        0.7,  0.35, -0.08, 0.65, 0.7,  0.35,  0.2};
constexpr double kPointingAngles_rad[] = {0.5, 0.1, 0.3, 0.35, 0,   0.15, 0.2, 0.1,  0,   0.7, 0.9,
                                          0.4, 0,   0.8, 0.95, 0.4, 0,    0.8, 0.95, 0.4, 0.08};

HandState personalise(const double* typical, const HandState& personal, const RobotModel& hand) {
  HandState state = Eigen::Map<const HandState>(typical) + personal;
  state = state.cwiseMax(hand.lower).cwiseMin(hand.upper);
  state[kMiddleAbduction] = 0;
  return state;
}

}  // namespace

human::HandAngles hand_angles(const HandState& state) {
  human::HandAngles angles;
  std::copy_n(state.data(), kHandAngleCount, angles.joint.begin());
  angles.palm_arch = state[kHandStateSize - 1];
  return angles;
}

HandState flat_hand() { return HandState::Zero(); }

HandPostures draw_hand_postures(const RobotModel& hand, math::RandomStream& random) {
  constexpr double kSubjectSd_rad = 0.05;
  HandState personal;
  for (double& joint : personal) joint = kSubjectSd_rad * random.normal();
  return {personalise(kRestingAngles_rad, personal, hand),
          personalise(kOpenAngles_rad, personal, hand),
          personalise(kClosedAngles_rad, personal, hand),
          personalise(kPointingAngles_rad, personal, hand)};
}

double aperture(const RobotModel& hand, const HandState& state) {
  std::vector<Pose> frames;
  const human::HandPoints points = human::hand_points(hand, hand_angles(state), frames);
  return (points.tip[0] - points.tip[1]).norm();
}

HandState posture_of_aperture(const RobotModel& hand, const HandPostures& postures,
                              double aperture_m) {
  const auto posture_at = [&](double closure) -> HandState {
    return postures.open + closure * (postures.closed - postures.open);
  };
  constexpr int kMaxBisections = 24;
  double wider = 0, narrower = 1;
  for (int k = 0; k < kMaxBisections; ++k) {
    const double middle = 0.5 * (wider + narrower);
    (aperture(hand, posture_at(middle)) > aperture_m ? wider : narrower) = middle;
  }
  return posture_at(0.5 * (wider + narrower));
}

}  // namespace morphe::synthesize
