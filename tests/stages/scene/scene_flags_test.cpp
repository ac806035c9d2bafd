#include "stages/scene/scene_flags.hpp"

#include <gmock/gmock.h>

#include "core/config/fields.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::scene {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A hand that closes from 1 to 2 s, with thumb and index on either side of the origin along x, and
/// lies on the table at z = -height before.
struct ClosingHand {
  Demonstration recording;
  HumanMotion motion;
  Movement movement;
  SceneOptions options;

  ClosingHand(double aperture_m, double height_m) {
    motion.tip = {21, kFingerCount, unknown_point()};
    for (std::size_t i = 0; i < 21; ++i) {
      motion.time.push_back(0.1 * static_cast<double>(i));
      motion.wrist.push_back({0, -0.15, 0});
      const double z = i < 10 ? -height_m : 0;
      motion.tip(i, kThumb) = {-aperture_m / 2, 0, z};
      motion.tip(i, kIndex) = {aperture_m / 2, 0, z};
    }
    movement.phases = {{.kind = PhaseKind::reach, .begin_s = 0, .end_s = 1},
                       {.kind = PhaseKind::grasp, .begin_s = 1, .end_s = 2}};
    movement.end_s = 2;
  }
  void record(const char* name, const Vec3& position, double radius_m = 0.04) {
    SceneObject object;
    object.name = name;
    object.shape = Shape::sphere;
    object.size = {radius_m};
    object.time = {0};
    object.position = {position};
    object.orientation = {Quat::Identity()};
    recording.objects.push_back(object);
  }
  Scene scene() { return build_scene(options, recording, motion, movement); }
  std::vector<RecordingFlag> flags() {
    const Scene around = scene();
    return scene_flags(options, recording, motion, movement, around);
  }
};

TEST(SceneOrigins, AreThoseOfRecordingConfigAndInference) {
  ClosingHand inferred(0.094, 0.06);
  for (const SceneObject& object : inferred.scene().objects) {
    EXPECT_EQ(object.pose_origin, ObjectOrigin::inferred) << object.name;
    EXPECT_EQ(object.shape_origin, ObjectOrigin::inferred) << object.name;
  }
  ClosingHand recorded(0.094, 0.06);
  recorded.record("cup", {0, 0, 0});
  recorded.options.table.height = -0.05;
  recorded.options.target.body.emplace();
  recorded.options.target.body->shape = "sphere";
  recorded.options.target.body->size = {0.03};
  ConfiguredObject post;
  post.name = "post";
  post.shape = "sphere";
  post.size = {0.02};
  recorded.options.objects = {post};
  const Scene scene = recorded.scene();
  const SceneObject *table = find_object(scene.objects, "table"),
                    *cup = find_object(scene.objects, "cup");
  EXPECT_EQ(table->pose_origin, ObjectOrigin::configured);
  EXPECT_EQ(table->shape_origin, ObjectOrigin::inferred);
  EXPECT_EQ(cup->pose_origin, ObjectOrigin::recorded);
  EXPECT_EQ(cup->shape_origin, ObjectOrigin::configured);
  EXPECT_EQ(find_object(scene.objects, "post")->pose_origin, ObjectOrigin::configured);
}

TEST(SceneFlags, AHandAroundACupHasNone) {
  EXPECT_THAT(ClosingHand(0.094, 0.06).flags(), IsEmpty());
  ClosingHand recorded(0.102, 0.06);
  recorded.record("cup", {0, 0, 0});
  EXPECT_THAT(recorded.flags(), IsEmpty());
}

TEST(SceneFlags, TipsThatAlmostMeetHoldAThinThing) {
  ClosingHand thin(0.008, 0.06);
  const std::vector<RecordingFlag> flags = thin.flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].code, FlagCode::unlikely_target);
  EXPECT_EQ(flags[0].subject, "cup");
  EXPECT_NEAR(flags[0].value, 0.008 - 2 * 0.011, 1e-12);
  EXPECT_EQ(flags[0].limit, 0.03);
  EXPECT_THAT(flags[0].text, HasSubstr("8 mm apart"));
  EXPECT_THAT(flags[0].text, HasSubstr("thinner"));
  EXPECT_THAT(flags[0].text, HasSubstr("taken as 30 mm wide"));
  thin.options.target.radius = 0.004;
  EXPECT_THAT(thin.flags(), IsEmpty()) << "the user knows";
  EXPECT_EQ(find_object(thin.scene().objects, "cup")->shape_origin, ObjectOrigin::configured);
}

TEST(SceneFlags, TipsFarApartHoldAWideThing) {
  const std::vector<RecordingFlag> flags = ClosingHand(0.18, 0.06).flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_THAT(flags[0].text, HasSubstr("wider"));
  EXPECT_NEAR(flags[0].value, 0.18 - 0.022, 1e-12);
  EXPECT_EQ(flags[0].limit, 0.12);
}

TEST(SceneFlags, AGraspHighAboveTheTableHoldsSomethingInTheAir) {
  ClosingHand high(0.094, 0.539);
  const std::vector<RecordingFlag> flags = high.flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].code, FlagCode::unlikely_target);
  EXPECT_NEAR(flags[0].value, 0.539 + 0.012 + 0.02, 1e-12);
  EXPECT_THAT(flags[0].text, HasSubstr("571 mm tall"));
  EXPECT_THAT(flags[0].text, HasSubstr("taken as 100 mm tall"));
}

TEST(SceneFlags, ARecordedCupBesideTheTipsStaysThereAndIsTold) {
  ClosingHand beside(0.102, 0.06);
  beside.record("cup", {0.06, 0, 0});
  const std::vector<RecordingFlag> flags = beside.flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].code, FlagCode::target_offset);
  EXPECT_NEAR(flags[0].value, 0.06, 1e-9);  // along the line through the tips, from the surface
  EXPECT_THAT(flags[0].text, HasSubstr("60 mm from where it would touch cup as recorded"));
  EXPECT_EQ(find_object(beside.scene().objects, "cup")->position[0], Vec3(0.06, 0, 0));
}

TEST(SceneFlags, AnObjectThatIsNowhereNearTheHandIsTold) {
  ClosingHand hand(0.102, 0.06);
  hand.record("cup", {0, 0, 0});
  hand.record("bottle", {0, 2, 0});
  hand.record("plate", {0.5, 0.3, 0});
  const std::vector<RecordingFlag> flags = hand.flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].code, FlagCode::object_away);
  EXPECT_EQ(flags[0].subject, "bottle");
  EXPECT_NEAR(flags[0].value, 1.96, 0.01);
  EXPECT_THAT(flags[0].text, HasSubstr("1.96 m or more from the hand, nearest at 1.00 s"));
}

TEST(TargetOptions, BoundsOfAnInferredTargetCannotBeLeft) {
  for (const char* text :
       {"{height: 0.571}", "{height: 0.02}", "{min_radius: 0.001}", "{max_radius: 0.2}"}) {
    SceneOptions options;
    const config::ConfigNode node =
        config::ConfigNode::parse(std::string("{target: ") + text + "}", "scene.yaml");
    EXPECT_THROW(config::read_document(node, options), InputError) << text;
  }
}

}  // namespace
}  // namespace morphe::scene
