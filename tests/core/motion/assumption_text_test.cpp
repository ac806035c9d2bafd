#include "core/motion/assumption_text.hpp"

#include <gmock/gmock.h>

namespace morphe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Plan plan_with(ObjectOrigin pose, ObjectOrigin shape) {
  Plan plan;
  plan.movement.target = "cup";
  SceneObject cup;
  cup.name = "cup";
  cup.shape = Shape::cylinder;
  cup.size = {0.036, 0.12};
  cup.pose_origin = pose;
  cup.shape_origin = shape;
  plan.scene.objects = {cup};
  return plan;
}

TEST(ObjectAssumptions, NameWhatIsInferred) {
  const auto both = object_assumptions(plan_with(ObjectOrigin::inferred, ObjectOrigin::inferred));
  ASSERT_EQ(both.size(), 1u);
  EXPECT_EQ(both[0].kind, AssumptionKind::inferred);
  EXPECT_EQ(both[0].subject, "target");
  EXPECT_THAT(both[0].value, HasSubstr("cylinder of 72 x 72 x 120 mm"));
  const auto shape = object_assumptions(plan_with(ObjectOrigin::recorded, ObjectOrigin::inferred));
  ASSERT_EQ(shape.size(), 1u);
  EXPECT_THAT(shape[0].value, HasSubstr("its shape was not recorded"));
  EXPECT_THAT(object_assumptions(plan_with(ObjectOrigin::recorded, ObjectOrigin::recorded)),
              IsEmpty());
  EXPECT_THAT(object_assumptions(plan_with(ObjectOrigin::configured, ObjectOrigin::configured)),
              IsEmpty());
}

TEST(ObjectAssumptions, OfAnEarlierFileAreNotKnown) {
  const auto unknown = object_assumptions(plan_with(ObjectOrigin::unknown, ObjectOrigin::unknown));
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_THAT(unknown[0].value, HasSubstr("does not say"));
}

TEST(AssumptionTally, CountsPlansAndNotAssumptions) {
  const Assumption axes{AssumptionKind::assumed, "axes", "x y z"},
      target{AssumptionKind::inferred, "target", "cup"};
  AssumptionTally tally;
  tally.add({axes, axes, target});
  tally.add({target});
  ASSERT_EQ(tally.counted.size(), 2u);
  EXPECT_EQ(tally.counted[0].second, 1);
  EXPECT_EQ(tally.counted[1].second, 2);
  const std::vector<Assumption> of_file{{AssumptionKind::set_by_hand, "map.starts", "64"},
                                        {AssumptionKind::not_looked_at, "torque", "of the arm"}};
  EXPECT_EQ(subject_lines(of_file, tally, 2),
            "  inferred      target\n"
            "  assumed       axes (1 of 2 plans)\n"
            "  set by hand   map.starts=64\n"
            "  not looked at torque\n");
}

TEST(AllAssumptions, AreOrderedByKind) {
  PlanFileHeader header;
  header.assumptions = {{AssumptionKind::assumed, "limits", "a"},
                        {AssumptionKind::not_looked_at, "torque", "b"}};
  const Plan plan = plan_with(ObjectOrigin::inferred, ObjectOrigin::recorded);
  std::vector<std::string> subjects;
  for (const Assumption& each : all_assumptions(header, plan)) subjects.push_back(each.subject);
  EXPECT_THAT(subjects, ElementsAre("target", "limits", "torque"));
}

}  // namespace
}  // namespace morphe
