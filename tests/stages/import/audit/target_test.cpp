#include <gmock/gmock.h>

#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A hand that closes at the origin from 1 to 2 s, and a cup somewhere.
struct Grasp {
  Demonstration recording;
  HumanMotion motion;
  Movement movement;

  explicit Grasp(const Vec3& cup) {
    for (int i = 0; i <= 20; ++i) motion.time.push_back(0.1 * i);
    motion.tip = {21, kFingerCount, unknown_point()};
    for (std::size_t i = 0; i < 21; ++i) {
      motion.tip(i, kThumb) = {-0.03, 0, 0};
      motion.tip(i, kIndex) = {0.03, 0, 0};
    }
    movement.phases = {{.kind = PhaseKind::reach, .begin_s = 0, .end_s = 1},
                       {.kind = PhaseKind::grasp, .begin_s = 1, .end_s = 2}};
    movement.end_s = 2;
    add("cup", {0.04}, cup);
  }
  void add(const char* name, std::vector<double> size, const Vec3& position) {
    SceneObject object;
    object.name = name;
    object.shape = size.size() == 1 ? Shape::sphere : Shape::box;
    object.size = std::move(size);
    object.time = {0};
    object.position = {position};
    object.orientation = {Quat::Identity()};
    recording.objects.push_back(object);
  }
  std::vector<RecordingFlag> flags(const std::string& configured = "",
                                   const std::vector<std::string>& obstacles = {}) const {
    return check_target({recording, motion, movement, {}, configured, obstacles}, {});
  }
};

TEST(AuditTarget, ACupTwoMetresFromTheClosingTipsIsAway) {
  const std::vector<RecordingFlag> flags = Grasp({0, 2.04, 0}).flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].code, FlagCode::target_away);
  EXPECT_EQ(flags[0].subject, "cup");
  EXPECT_NEAR(flags[0].value, 2.0, 1e-12);  // from the surface
  EXPECT_EQ(flags[0].text,
            "thumb and index close 2.00 m from cup: is it in another frame or unit?");
  EXPECT_NE(refused_flag(flags, AuditOptions{}), nullptr);
}

TEST(AuditTarget, ACupBetweenOrBesideTheTipsIsNot) {
  EXPECT_THAT(Grasp({0, 0, 0}).flags(), IsEmpty());
  EXPECT_THAT(Grasp({0, 0.15, 0}).flags(), IsEmpty());
}

TEST(AuditTarget, AnyThingThatAHandTakesMayBeTheTarget) {
  Grasp grasp({0, 2, 0});
  grasp.add("ball", {0.03}, {0, 0.02, 0});
  EXPECT_THAT(grasp.flags(), IsEmpty());
  EXPECT_THAT(grasp.flags("cup"), SizeIs(1));  // the configuration says that the cup is
  grasp.movement.target = "ball";
  EXPECT_THAT(grasp.flags("cup"), IsEmpty());  // the recording that the ball was taken
}

TEST(AuditTarget, ObstaclesAndFurnitureAreNoTargets) {
  Grasp grasp({0, 2, 0});
  grasp.recording.objects.clear();
  grasp.add("table", {1, 1, 0.02}, {0, 2, 0});
  grasp.add("cupboard", {0.6, 0.4, 1.8}, {0, 2, 0});
  grasp.add("other forearm", {0.05}, {0, 2, 0});
  EXPECT_THAT(grasp.flags("", {"other forearm"}), IsEmpty());
  EXPECT_THAT(grasp.flags(), SizeIs(1));
}

TEST(AuditTarget, WithoutAGraspOnlyObjectsOutOfReachAreAway) {
  Grasp near({0, 0.9, 0}), far({0, 2.04, 0});
  near.movement.phases.pop_back();
  far.movement.phases.pop_back();
  EXPECT_THAT(near.flags(), IsEmpty());
  const std::vector<RecordingFlag> flags = far.flags();
  ASSERT_THAT(flags, SizeIs(1));
  EXPECT_EQ(flags[0].text, "thumb and index stay 2.00 m from cup: is it in another frame or unit?");
}

/// A hand at the origin and the object of the grasp.
std::vector<Doubt> doubts_about(const Vec3& position, const std::vector<double>& size) {
  Grasp grasp(position);
  grasp.recording.objects.clear();
  grasp.add("cup", size, position);
  MarkerStream& markers = grasp.recording.streams.markers.emplace();
  markers.names = {"RFTP"};
  markers.time = {0};
  markers.position = {1, 1, Vec3::Zero()};
  return check_objects(grasp.recording, {});
}

TEST(AuditObjects, AThingOfAnotherUnitIsTooFarTooLargeOrTooSmall) {
  EXPECT_THAT(doubts_about({0, 0.5, 0}, {0.08, 0.08, 0.1}), IsEmpty());
  EXPECT_THAT(doubts_about({4, 4, 0}, {3, 0.1, 2}), IsEmpty());  // a wall
  for (const auto& doubts :
       {doubts_about({0, 859, 0}, {0.08, 0.08, 0.1}), doubts_about({0, 0.5, 0}, {80, 80, 100}),
        doubts_about({0, 0.5, 0}, {8e-5, 8e-5, 1e-4})}) {
    ASSERT_THAT(doubts, SizeIs(1));
    EXPECT_EQ(doubts[0].flag.code, FlagCode::scale);
    EXPECT_EQ(doubts[0].flag.subject, "cup");
  }
}

}  // namespace
}  // namespace morphe::imports
