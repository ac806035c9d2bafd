#include "pipeline/report/selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/stages/certify/planar_arm.hpp"

namespace morphe::report {
namespace {

using testing::ElementsAre;

/// Five infeasible plans d0/000 … d4/000 without goals, the second and fourth out of reach by a
/// share.
std::filesystem::path file_of_five() {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "selection_test.h5";
  PlanFileHeader header;
  header.software = "morphe";
  const RobotTable robot = certify::planar_arm();
  store::PlanWriter writer(file, header, robot);
  for (int k = 0; k < 5; ++k) {
    Plan plan;
    plan.demonstration = "d" + std::to_string(k);
    plan.reason = Reason::tracking;
    const std::size_t tips = robot.tips.size();
    plan.goals.time = {0, 1};
    plan.goals.tip_position = Table<Vec3>(2, tips, Vec3::Zero());
    plan.goals.tip_orientation = Table<Quat>(2, tips, unseen_rotation());
    plan.goals.reachable = Table<std::uint8_t>(2, tips, 1);
    if (k == 1) plan.goals.reachable(0, 0) = 0;
    if (k == 3) plan.goals.reachable = Table<std::uint8_t>(2, tips, 0);
    plan.goals.shoulder_position = plan.goals.elbow_position =
        plan.goals.wrist_position = {Vec3::Zero(), Vec3::Zero()};
    plan.goals.wrist_orientation = {Quat::Identity(), Quat::Identity()};
    plan.goals.finger_joint_position = Table<Vec3>(2, 5, unseen_point());
    writer.add(plan);
  }
  writer.finish();
  return file;
}

TEST(Matches, StarsAndQuestionMarks) {
  EXPECT_TRUE(matches("ADL001DR2/000", "ADL001*"));
  EXPECT_TRUE(matches("ADL001DR2/000", "*DR?/00?"));
  EXPECT_TRUE(matches("a", "**"));
  EXPECT_FALSE(matches("ADL001DR2/000", "ADL001"));
  EXPECT_FALSE(matches("ADL001DR2/000", "?DR2*"));
  EXPECT_FALSE(matches("", "?"));
}

TEST(SelectPlans, AllWithoutAWish) {
  const store::PlanReader reader(file_of_five());
  const Selected all = select_plans(reader, {});
  EXPECT_THAT(all.plans, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(all.left_out, "");
}

TEST(SelectPlans, ByNameAndWorst) {
  const store::PlanReader reader(file_of_five());
  EXPECT_THAT(select_plans(reader, {.pattern = "d[0]*", .by = ""}).plans, testing::IsEmpty());
  EXPECT_THAT(select_plans(reader, {.pattern = "d?/000", .failed = true, .by = ""}).plans,
              ElementsAre(0, 1, 2, 3, 4));
  const Selected worst = select_plans(reader, {.pattern = "", .worst = 2, .by = "out_of_reach"});
  EXPECT_THAT(worst.plans, ElementsAre(1, 3));
  EXPECT_EQ(worst.left_out, "3 of 5 plans are left out: shown are the 2 worst by out_of_reach");
}

TEST(SelectPlans, OfEqualsTheEarlierAndThoseWithoutAValueLast) {
  const store::PlanReader reader(file_of_five());
  EXPECT_THAT(select_plans(reader, {.pattern = "", .worst = 3, .by = "out_of_reach"}).plans,
              ElementsAre(0, 1, 3));
  EXPECT_THAT(select_plans(reader, {.pattern = "", .worst = 2, .by = "clearance"}).plans,
              ElementsAre(0, 1));
}

}  // namespace
}  // namespace morphe::report
