#include "pipeline/synthesize/waypoint_sampler.hpp"

#include <cmath>

namespace morphe::synthesize {

ArmState WaypointSampler::draw_home() {
  ArmState state;
  const Vec3 ahead(random_.uniform(-0.1, 0.02), random_.uniform(0.17, 0.25), 0);
  Vec3 wrist = subject_.shoulder + ahead;
  wrist.z() = random_.uniform(0.035, 0.05);
  state << wrist, random_.uniform(0.8, 1.15), random_.uniform(-0.2, 0.05),
      random_.uniform(-0.1, 0.1), swivel(), subject_.shoulder;
  return clamp_to_reach(subject_.shoulder, state);
}

ArmState WaypointSampler::draw_target(const ArmState& home) {
  constexpr int kMaxTries = 20;
  ArmState state = home, target = home;
  double max_distance_m = 0;
  for (int k = 0; k < kMaxTries; ++k) {
    const double direction = random_.uniform(options_.direction);
    const double distance = random_.uniform(options_.distance);
    Vec3 wrist = home.segment<3>(kWristPosition) +
                 distance * Vec3(std::sin(direction), std::cos(direction), 0);
    wrist.z() = random_.uniform(options_.height);
    state.segment<3>(kWristPosition) = wrist;
    const ArmState reached = clamp_to_reach(home.segment<3>(kWristPosition), state);
    const double distance_m = (reached - home).segment<3>(kWristPosition).norm();
    if (distance_m > max_distance_m) {
      max_distance_m = distance_m;
      target = reached;
    }
    if (reached == state) break;
  }
  target[kPronation] = random_.uniform(0, 0.45);
  target[kFlexion] = random_.uniform(-0.45, -0.1);
  target[kDeviation] = random_.uniform(-0.2, 0.2);
  target[kSwivel] = swivel();
  const Vec3 leaning = target.segment<3>(kWristPosition) - home.segment<3>(kWristPosition);
  target.segment<3>(kShoulderPosition) += random_.uniform(0, 0.06) * leaning;
  return target;
}

ArmState WaypointSampler::draw_lift(const ArmState& target) {
  ArmState state = target;
  state.segment<3>(kWristPosition) +=
      Vec3(random_.uniform(-0.1, 0.1), random_.uniform(-0.15, 0), random_.uniform(0.08, 0.2));
  state[kPronation] += random_.uniform(-0.2, 0.2);
  state[kFlexion] += random_.uniform(-0.15, 0.15);
  state[kSwivel] += random_.uniform(-0.1, 0.2);
  return clamp_to_reach(target.segment<3>(kWristPosition), state);
}

ArmState WaypointSampler::perturb(const ArmState& place, double spread_m, double spread_rad) {
  ArmState state = place;
  state.segment<3>(kWristPosition) += spread_m * random_.normal_vector3();
  for (int k = kPronation; k <= kSwivel; ++k) state[k] += spread_rad * random_.normal();
  return clamp_to_reach(place.segment<3>(kWristPosition), state);
}

ArmState WaypointSampler::clamp_to_reach(const Vec3& from, ArmState state) const {
  const double max_distance_m =
      options_.reach_share * (subject_.body.arm.upper_arm + subject_.body.arm.forearm);
  const Vec3 shoulder = state.segment<3>(kShoulderPosition), to = state.segment<3>(kWristPosition);
  const auto is_too_far = [&](double share) {
    return (from + share * (to - from) - shoulder).norm() > max_distance_m;
  };
  if (!is_too_far(1)) return state;
  double within = 0, beyond = 1;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (within + beyond);
    (is_too_far(middle) ? beyond : within) = middle;
  }
  state.segment<3>(kWristPosition) = from + within * (to - from);
  return state;
}

}  // namespace morphe::synthesize
