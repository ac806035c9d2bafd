#include "pipeline/planning/partial_delivery.hpp"

#include <gmock/gmock.h>

namespace morphe::planning {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using enum PhaseKind;

/// A cup that is carried to the mouth and back, and left.
Movement drinking() {
  Movement movement{0, 1, 6, {}, "cup"};
  movement.phases = {{reach, 1, 2},       {preshape, 1.2, 2},     {grasp, 2, 2.2},
                     {transport, 2.2, 3}, {hold, 3, 3.2},         {transport, 3.2, 4},
                     {hold, 4, 4.2},      {return_phase, 4.2, 6}, {lift, 2.2, 2.4},
                     {place, 3.8, 4},     {release, 4, 4.5},      {retreat, 4.5, 5},
                     {home, 5, 6}};
  return movement;
}

std::vector<PhaseKind> cuts(const Movement& movement, PartialPlans partial) {
  std::vector<PhaseKind> kinds;
  for (const Phase& phase : permitted_cuts(movement, partial)) kinds.push_back(phase.kind);
  return kinds;
}

TEST(PermittedCuts, LeaveNothingInTheAir) {
  Movement movement = drinking();
  EXPECT_THAT(cuts(movement, PartialPlans::at_rest),
              ElementsAre(retreat, release, place, transport, grasp));
  EXPECT_THAT(cuts(movement, PartialPlans::in_air),
              ElementsAre(retreat, release, place, transport, lift, grasp));
  EXPECT_THAT(cuts(movement, PartialPlans::never), IsEmpty());
  movement.end_s = 4;  // plan_until: transport
  EXPECT_THAT(cuts(movement, PartialPlans::at_rest), ElementsAre(grasp));
  movement.end_s = 2.2;
  EXPECT_THAT(cuts(movement, PartialPlans::at_rest), IsEmpty());
}

TEST(PermittedCuts, AThingThatIsNotLeftMayStillBeInTheHand) {
  Movement movement = drinking();
  std::erase_if(movement.phases, [](const Phase& phase) { return phase.end_s > 4; });
  EXPECT_THAT(cuts(movement, PartialPlans::at_rest), ElementsAre(grasp));
}

TEST(PermittedCuts, AHandThatTakesNothingMayEndItsReach) {
  Movement movement{0, 1, 4, {{reach, 1, 2}, {hold, 2, 3}, {return_phase, 3, 4}}, ""};
  EXPECT_THAT(cuts(movement, PartialPlans::at_rest), ElementsAre(reach));
}

}  // namespace
}  // namespace morphe::planning
