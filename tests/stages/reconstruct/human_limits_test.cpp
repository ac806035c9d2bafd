#include "stages/reconstruct/human_limits.hpp"

#include <gtest/gtest.h>

#include "stages/reconstruct/arm_kinematics.hpp"

namespace morphe::reconstruct {
namespace {

/// An arm stretched level to the front, or straight back: no shoulder does that.
HumanMotion stretched(double forward) {
  HumanMotion motion;
  for (int i = 0; i < 10; ++i) {
    motion.time.push_back(0.01 * i);
    motion.shoulder.emplace_back(0, 0, 1.4);
    motion.elbow.emplace_back(0, 0.3 * forward, 1.4);
    motion.wrist.emplace_back(0, 0.54 * forward, 1.45);
    motion.wrist_orientation.push_back(Quat::Identity());
  }
  return motion;
}

TEST(HumanLimits, AnArmStretchedBackwardIsNoPersons) {
  HumanMotion person = stretched(1), none = stretched(-1);
  add_arm_angles(person);
  add_arm_angles(none);
  EXPECT_FALSE(check_human_limits(person, {}));
  const PlanningFailure refusal = check_human_limits(none, {});
  EXPECT_EQ(name_of(refusal.reason), "implausible_arm");
  EXPECT_NE(refusal.detail.find("100 mm"), std::string::npos) << refusal.detail;
  HumanOptions patient;
  patient.max_limit_violation_m = 1;
  EXPECT_FALSE(check_human_limits(none, patient));
}

}  // namespace
}  // namespace morphe::reconstruct
