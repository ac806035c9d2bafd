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
  const RobotModel robot = certify::planar_arm();
  store::PlanWriter writer(file, header, robot);
  for (int k = 0; k < 5; ++k) {
    Plan plan;
    plan.demonstration = "d" + std::to_string(k);
    plan.reason = Reason::tracking;
    const std::size_t tips = robot.tips.size();
    plan.goals.time = {0, 1};
    plan.goals.tip_position = Array2D<Vec3>(2, tips, Vec3::Zero());
    plan.goals.tip_orientation = Array2D<Quat>(2, tips, unknown_rotation());
    plan.goals.reachable = Array2D<std::uint8_t>(2, tips, 1);
    if (k == 1) plan.goals.reachable(0, 0) = 0;
    if (k == 3) plan.goals.reachable = Array2D<std::uint8_t>(2, tips, 0);
    plan.goals.shoulder_position = plan.goals.elbow_position =
        plan.goals.wrist_position = {Vec3::Zero(), Vec3::Zero()};
    plan.goals.wrist_orientation = {Quat::Identity(), Quat::Identity()};
    plan.goals.finger_joint_position = Array2D<Vec3>(2, 5, unknown_point());
    writer.add(plan);
  }
  writer.finish();
  return file;
}

TEST(Matches, StarsAndQuestionMarks) {
  EXPECT_TRUE(matches_pattern("ADL001DR2/000", "ADL001*"));
  EXPECT_TRUE(matches_pattern("ADL001DR2/000", "*DR?/00?"));
  EXPECT_TRUE(matches_pattern("a", "**"));
  EXPECT_FALSE(matches_pattern("ADL001DR2/000", "ADL001"));
  EXPECT_FALSE(matches_pattern("ADL001DR2/000", "?DR2*"));
  EXPECT_FALSE(matches_pattern("", "?"));
}

TEST(SelectPlans, AllWithoutAWish) {
  const store::PlanReader reader(file_of_five());
  const SelectedPlans all = select_plans(reader, {});
  EXPECT_THAT(all.plans, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(all.left_out, "");
}

TEST(SelectPlans, ByNameAndWorst) {
  const store::PlanReader reader(file_of_five());
  EXPECT_THAT(select_plans(reader, {.pattern = "d[0]*", .ranking_measure = ""}).plans,
              testing::IsEmpty());
  EXPECT_THAT(
      select_plans(reader, {.pattern = "d?/000", .infeasible_only = true, .ranking_measure = ""})
          .plans,
      ElementsAre(0, 1, 2, 3, 4));
  const SelectedPlans worst = select_plans(
      reader, {.pattern = "", .worst_count = 2, .ranking_measure = "unreachable_share"});
  EXPECT_THAT(worst.plans, ElementsAre(1, 3));
  EXPECT_EQ(worst.left_out, "3 of 5 plans are hidden; shown are the 2 worst by unreachable_share");
}

TEST(SelectPlans, OfEqualsTheEarlierAndThoseWithoutAValueLast) {
  const store::PlanReader reader(file_of_five());
  EXPECT_THAT(select_plans(
                  reader, {.pattern = "", .worst_count = 3, .ranking_measure = "unreachable_share"})
                  .plans,
              ElementsAre(0, 1, 3));
  EXPECT_THAT(
      select_plans(reader, {.pattern = "", .worst_count = 2, .ranking_measure = "clearance"}).plans,
      ElementsAre(0, 1));
}

}  // namespace
}  // namespace morphe::report
