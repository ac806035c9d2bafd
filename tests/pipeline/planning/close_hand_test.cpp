#include "pipeline/planning/close_hand.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pipeline/planning/clearance_weights.hpp"
#include "pipeline/planning/constants.hpp"
#include "stages/grasp/close_fingers.hpp"
#include "stages/grasp/measure.hpp"
#include "stages/map/map_movement.hpp"
#include "tests/stages/grasp/rod_before_the_hand.hpp"

namespace morphe::planning {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::size_t kMiddle = 2;
constexpr double kTime_s = 0.6;

/// A rod before a hand whose fingers are nearly straight, and the same hand with its middle finger
/// bent.
struct RodBeforeABentFinger {
  grasp::RodBeforeTheHand rod;
  JointVector bent;
  map::MapOptions options;
  Goals goals;

  RodBeforeABentFinger(double from_palm, double up_the_fingers)
      : rod(from_palm, up_the_fingers), bent(rod.q) {
    const auto joint = std::ranges::find(rod.robot.joint_names, "middle_middle");
    const auto index = joint - rod.robot.joint_names.begin();
    bent[index] = rod.robot.upper[index];
    goals.time = {kTime_s};
    goals.tip_position = {1, rod.robot.tips.size(), unknown_point()};
    goals.tip_orientation = {1, rod.robot.tips.size(), unknown_rotation()};
    goals.reachable = {1, rod.robot.tips.size(), 0};
    goals.finger_joint_position = {1, kFingerCount, unknown_point()};
    goals.shoulder_position = goals.elbow_position = goals.wrist_position = {unknown_point()};
    goals.wrist_orientation = {unknown_rotation()};
  }

  /// Returns true if the middle finger touches as grasp::close_fingers() turns it from q.
  bool touches_as_it_turns(const JointVector& q) const {
    return !grasp::close_fingers(rod.world, kTime_s, {kMiddle}, q).closings.empty();
  }

  std::vector<std::string> close(ContactPosture& touching) const {
    const map::MappingProblem problem = with_clearance_weights(
        map::make_mapping_problem(rod.robot, goals, rod.world, options), kContactPostureWeights);
    return close_hand(problem, 0, {kMiddle}, options, 1, touching);
  }
};

TEST(CloseHand, AFingerThatMissesTheTargetAsItTurnsSlidesToItFromOtherPostures) {
  int reached = 0;
  for (const double from_palm : {0.06, 0.08, 0.09, 0.1}) {
    for (const double up : {0.15, 0.17, 0.19, 0.2}) {
      const RodBeforeABentFinger of(from_palm, up);
      if (of.touches_as_it_turns(of.bent)) continue;
      ContactPosture touching{of.bent, {}};
      if (!of.close(touching).empty()) continue;
      ++reached;
      const std::vector<PadContact> contacts =
          grasp::measure_contacts(of.rod.world, touching.contacts, touching.q, kTime_s);
      ASSERT_EQ(contacts.size(), 1U);
      EXPECT_EQ(contacts[0].tip, "middle_tip");
      EXPECT_EQ(contacts[0].origin, ContactOrigin::auto_closed);
      EXPECT_EQ(contacts[0].state, ContactState::touching) << from_palm << " " << up;
      EXPECT_LT((contacts[0].point - contacts[0].desired_point).norm(), 1e-4);
      EXPECT_TRUE(grasp::closes_freely(of.rod.world, kTime_s, {kMiddle, {}}, of.bent, touching.q));
      // Keeps the other joints by kHeldHandWeight, against what the clearance of the arm pulls.
      for (Eigen::Index j = 0; j < touching.q.size(); ++j) {
        const std::string& name = of.rod.robot.joint_names[static_cast<std::size_t>(j)];
        if (name.starts_with("middle")) continue;
        EXPECT_NEAR(touching.q[j], of.bent[j], 1 * kRadPerDegree) << name;
      }
    }
  }
  EXPECT_GT(reached, 0) << "no rod that is missed is reached";
}

TEST(CloseHand, AFingerThatReachesFromNowhereStaysAsItIsAndSaysWhy) {
  const RodBeforeABentFinger far(0.25, 0.185);
  ContactPosture touching{far.bent, {}};
  EXPECT_THAT(far.close(touching),
              ElementsAre(HasSubstr("middle_tip stays open: it does not reach")));
  EXPECT_TRUE(touching.contacts.empty());
  EXPECT_EQ(touching.q, far.bent);
}

}  // namespace
}  // namespace morphe::planning
