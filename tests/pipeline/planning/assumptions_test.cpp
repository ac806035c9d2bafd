#include "pipeline/planning/assumptions.hpp"

#include <gmock/gmock.h>

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> subjects(const std::vector<Assumption>& assumptions, AssumptionKind kind) {
  std::vector<std::string> found;
  for (const Assumption& each : assumptions)
    if (each.kind == kind) found.push_back(each.subject);
  return found;
}

TEST(ConfigAssumptions, OfTheDefaultsAreWhatNobodyLooksAt) {
  const auto all = config_assumptions({}, {}, {});
  EXPECT_THAT(subjects(all, AssumptionKind::assumed), IsEmpty());
  EXPECT_THAT(subjects(all, AssumptionKind::set_by_hand), IsEmpty());
  EXPECT_THAT(subjects(all, AssumptionKind::not_looked_at),
              ElementsAre("grasp", "torque", "payload", "tracking", "calibration", "surroundings"));
}

TEST(ConfigAssumptions, OfAGraspAreFrictionMassAndStiffness) {
  PipelineConfig config;
  config.grasp.emplace();
  config.grasp->mass_kg = 0.7;
  const auto all =
      config_assumptions(config, {{AssumptionKind::assumed, "limits", "arm: guessed"}}, {});
  EXPECT_THAT(subjects(all, AssumptionKind::assumed),
              ElementsAre("limits", "friction", "mass", "hand_stiffness"));
  EXPECT_THAT(all, Contains(Field(&Assumption::value, "target of 0.7 kg, as configured")));
  EXPECT_THAT(subjects(all, AssumptionKind::not_looked_at), testing::Not(Contains("grasp")));
}

TEST(ConfigAssumptions, SetByHandAreSettingsAndLooserTolerances) {
  PipelineConfig config;
  config.check.tolerances.max_penetration = 0.02;
  config.check.tolerances.required_clearance = 0.005;  // stricter than the default
  config.check.tolerances.tracking_tolerance = 0.03;
  const auto all = config_assumptions(config, {}, {"map.starts=64", "a.b=c=d"});
  EXPECT_THAT(
      subjects(all, AssumptionKind::set_by_hand),
      ElementsAre("check.max_penetration", "check.tracking_tolerance", "map.starts", "a.b"));
  EXPECT_THAT(all, Contains(Field(&Assumption::value, "0.02 (default 0.005)")));
  EXPECT_THAT(all, Contains(Field(&Assumption::value, "c=d")));
}

TEST(ForbiddenAssumption, IsTheFirstOneThatMustBeKnown) {
  const std::vector<Assumption> all{{AssumptionKind::assumed, "mount", "arm: no rotation"},
                                    {AssumptionKind::inferred, "table", "from the tips"},
                                    {AssumptionKind::set_by_hand, "target", "by a setting"}};
  EXPECT_EQ(forbidden_assumption({}, all), "");
  EXPECT_EQ(forbidden_assumption({Knowable::limits, Knowable::target}, all), "");
  EXPECT_THAT(forbidden_assumption({Knowable::table}, all), HasSubstr("scene.table.height"));
  EXPECT_THAT(forbidden_assumption({Knowable::table, Knowable::mount}, all),
              HasSubstr("the mount must be known, but is assumed (arm: no rotation)"));
}

TEST(RefusedAssumption, LooksAtRecordingAndScene) {
  Plan begun;
  begun.movement.target = "cup";
  Scene scene;
  scene.objects.emplace_back();
  scene.objects[0].name = "cup";
  scene.objects[0].pose_origin = scene.objects[0].shape_origin = ObjectOrigin::recorded;
  EXPECT_FALSE(refused_assumption({Knowable::target}, begun, scene));
  scene.objects[0].shape = Shape::sphere;
  scene.objects[0].size = {0.03};
  scene.objects[0].shape_origin = ObjectOrigin::inferred;
  EXPECT_EQ(refused_assumption({Knowable::target}, begun, scene).reason, Reason::not_known);
  EXPECT_FALSE(refused_assumption({Knowable::table, Knowable::axes}, begun, scene));
  begun.recording_assumptions = {{AssumptionKind::assumed, "axes", "x y z"}};
  EXPECT_EQ(refused_assumption({Knowable::axes}, begun, scene).reason, Reason::not_known);
}

}  // namespace
}  // namespace morphe::planning
