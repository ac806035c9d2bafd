#include "stages/map/phase_weights.hpp"

#include <gtest/gtest.h>

namespace morphe::map {
namespace {

const std::vector<Phase> kReachAndGrasp{{PhaseKind::reach, 0, 1}, {PhaseKind::grasp, 1, 1.5}};
const std::vector<PhaseWeights> kHumanlikeReach{{PhaseKind::reach, 0.5, 1, 4, 1},
                                                {PhaseKind::grasp, 2, 1, 1, 1}};

TEST(PhaseWeights, InsideAPhaseTheyAreItsOwn) {
  const humanlike::FrameWeights reach = weights_at(kHumanlikeReach, kReachAndGrasp, 0.5, 0.2);
  EXPECT_NEAR(reach.tip_position, 0.5, 1e-12);
  EXPECT_NEAR(reach.humanlike_arm, 4, 1e-12);
  EXPECT_NEAR(weights_at(kHumanlikeReach, kReachAndGrasp, 1.25, 0.2).tip_position, 2, 1e-12);
}

TEST(PhaseWeights, OneIsTheWeightOfWhatIsNotListed) {
  EXPECT_NEAR(weights_at(kHumanlikeReach, kReachAndGrasp, 3, 0.2).tip_position, 1, 1e-12);
  EXPECT_EQ(weights_at({}, kReachAndGrasp, 0.5, 0.2).humanlike_arm, 1);
}

TEST(PhaseWeights, NothingJumpsAtABoundary) {
  // Half and half on it; the steepest slope of a raised cosine is twice the mean one.
  EXPECT_NEAR(weights_at(kHumanlikeReach, kReachAndGrasp, 1, 0.2).tip_position, 1.25, 1e-12);
  double last = 0.5;
  for (double t = 0.85; t < 1.15; t += 0.002) {
    const double now = weights_at(kHumanlikeReach, kReachAndGrasp, t, 0.2).tip_position;
    EXPECT_GE(now, last - 1e-12);
    EXPECT_LT(now - last, 1.5 * 0.002 * 2 / 0.2 + 1e-12);
    last = now;
  }
  EXPECT_NEAR(last, 2, 1e-12);
}

TEST(PhaseWeights, ALiftHasThoseOfItsTransportUnlessItIsListed) {
  std::vector<Phase> phases{{PhaseKind::transport, 0, 2}};
  std::vector<PhaseWeights> weights{{PhaseKind::transport, 3, 1, 1, 1}};
  const double without = weights_at(weights, phases, 0.98, 0.2).tip_position;
  phases.push_back({PhaseKind::lift, 0, 1});
  EXPECT_NEAR(weights_at(weights, phases, 0.98, 0.2).tip_position, without, 1e-12);
  weights.push_back({PhaseKind::lift, 5, 1, 1, 1});
  EXPECT_NEAR(weights_at(weights, phases, 0.5, 0.2).tip_position, 5, 1e-12);
  EXPECT_NEAR(weights_at(weights, phases, 1.5, 0.2).tip_position, 3, 1e-12);
}

TEST(PhaseWeights, RefusesAPhaseNamedTwice) {
  EXPECT_NE(validation_error({{PhaseKind::reach, 1, 1, 1, 1}, {PhaseKind::reach, 1, 1, 1, 1}}), "");
  EXPECT_EQ(validation_error(kHumanlikeReach), "");
}

}  // namespace
}  // namespace morphe::map
