#include "pipeline/synthesize/places.hpp"

#include <cmath>

namespace morphe::synthesize {

ArmState Places::home() {
  ArmState state;
  const Vec3 ahead(random_.uniform(-0.1, 0.02), random_.uniform(0.17, 0.25), 0);
  Vec3 wrist = subject_.shoulder + ahead;
  wrist.z() = random_.uniform(0.035, 0.05);
  state << wrist, random_.uniform(0.8, 1.15), random_.uniform(-0.2, 0.05),
      random_.uniform(-0.1, 0.1), swivel(), subject_.shoulder;
  return within_reach(subject_.shoulder, state);
}

ArmState Places::target(const ArmState& home) {
  constexpr int kTries = 20;
  ArmState state = home, best = home;
  double farthest = 0;
  for (int k = 0; k < kTries; ++k) {
    const double direction = random_.uniform(options_.direction);
    const double distance = random_.uniform(options_.distance);
    Vec3 wrist =
        home.segment<3>(kWristAt) + distance * Vec3(std::sin(direction), std::cos(direction), 0);
    wrist.z() = random_.uniform(options_.height);
    state.segment<3>(kWristAt) = wrist;
    const ArmState reached = within_reach(home.segment<3>(kWristAt), state);
    const double way = (reached - home).segment<3>(kWristAt).norm();
    if (way > farthest) {
      farthest = way;
      best = reached;
    }
    if (reached == state) break;
  }
  best[kPronation] = random_.uniform(0, 0.45);
  best[kFlexion] = random_.uniform(-0.45, -0.1);
  best[kDeviation] = random_.uniform(-0.2, 0.2);
  best[kSwivel] = swivel();
  const Vec3 leaning = best.segment<3>(kWristAt) - home.segment<3>(kWristAt);
  best.segment<3>(kShoulderAt) += random_.uniform(0, 0.06) * leaning;
  return best;
}

ArmState Places::lifted(const ArmState& target) {
  ArmState state = target;
  state.segment<3>(kWristAt) +=
      Vec3(random_.uniform(-0.1, 0.1), random_.uniform(-0.15, 0), random_.uniform(0.08, 0.2));
  state[kPronation] += random_.uniform(-0.2, 0.2);
  state[kFlexion] += random_.uniform(-0.15, 0.15);
  state[kSwivel] += random_.uniform(-0.1, 0.2);
  return within_reach(target.segment<3>(kWristAt), state);
}

ArmState Places::again(const ArmState& place, double spread_m, double spread_rad) {
  ArmState state = place;
  state.segment<3>(kWristAt) += spread_m * random_.normals();
  for (int k = kPronation; k <= kSwivel; ++k) state[k] += spread_rad * random_.normal();
  return within_reach(place.segment<3>(kWristAt), state);
}

ArmState Places::within_reach(const Vec3& from, ArmState state) const {
  const double reach =
      options_.reach_share * (subject_.body.arm.upper_arm + subject_.body.arm.forearm);
  const Vec3 shoulder = state.segment<3>(kShoulderAt), to = state.segment<3>(kWristAt);
  const auto out_of_reach = [&](double share) {
    return (from + share * (to - from) - shoulder).norm() > reach;
  };
  if (!out_of_reach(1)) return state;
  double within = 0, beyond = 1;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (within + beyond);
    (out_of_reach(middle) ? beyond : within) = middle;
  }
  state.segment<3>(kWristAt) = from + within * (to - from);
  return state;
}

}  // namespace morphe::synthesize
