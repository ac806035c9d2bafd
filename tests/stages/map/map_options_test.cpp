#include "stages/map/map_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "stages/map/compass_search.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"

namespace morphe::map {
namespace {

using testing::HasSubstr;

MapOptions with_mode(MapMode mode) {
  MapOptions options;
  options.mode = mode;
  options.objective.get<humanlike::TriangleArea>().weight = 0.5;
  options.objective.get<humanlike::HullVolume>().weight = 2;
  options.natural_posture = {{"arm_1", "", 0.1}};
  return options;
}

TEST(MapMode, LeavesOutWhatItSays) {
  const robot::Robot robot(robot::generate_arm({6, 0.6}));
  const auto made = [&](MapMode mode) { return make_objective(with_mode(mode), robot); };
  const humanlike::FrameObjective usual = default_objective();

  const humanlike::FrameObjective all = made(MapMode::humanlike);
  EXPECT_EQ(all.get<humanlike::JointDistance>().weight,
            usual.get<humanlike::JointDistance>().weight);
  EXPECT_EQ(all.get<humanlike::FingerJointDistance>().weight,
            usual.get<humanlike::FingerJointDistance>().weight);
  EXPECT_EQ(all.get<humanlike::TriangleArea>().weight, 0.5);
  EXPECT_EQ(all.get<humanlike::HullVolume>().weight, 2);
  EXPECT_EQ(all.get<humanlike::ChainPosition>().weight, 0);
  EXPECT_EQ(all.get<humanlike::JointAngle>().weight, 0);

  for (const MapMode mode :
       {MapMode::inverse_kinematics, MapMode::fingertip_only, MapMode::joint_to_joint}) {
    const humanlike::FrameObjective some = made(mode);
    EXPECT_EQ(some.get<humanlike::JointDistance>().weight, 0) << name_of(mode);
    EXPECT_EQ(some.get<humanlike::FingerJointDistance>().weight, 0) << name_of(mode);
    EXPECT_EQ(some.get<humanlike::TriangleArea>().weight, 0) << name_of(mode);
    EXPECT_EQ(some.get<humanlike::HullVolume>().weight, 0) << name_of(mode);
    EXPECT_EQ(some.get<humanlike::TipPosition>().weight, usual.get<humanlike::TipPosition>().weight)
        << name_of(mode);
    EXPECT_EQ(some.get<humanlike::NaturalPosture>().weight,
              usual.get<humanlike::NaturalPosture>().weight)
        << name_of(mode);
    EXPECT_EQ(some.get<humanlike::NaturalPosture>().joints.size(), 1u) << name_of(mode);
  }
  EXPECT_EQ(made(MapMode::inverse_kinematics).get<humanlike::TipOrientation>().weight,
            usual.get<humanlike::TipOrientation>().weight);
  EXPECT_EQ(made(MapMode::inverse_kinematics).get<humanlike::HandOrientation>().weight,
            usual.get<humanlike::HandOrientation>().weight);
  EXPECT_EQ(made(MapMode::fingertip_only).get<humanlike::TipOrientation>().weight, 0);
  EXPECT_EQ(made(MapMode::fingertip_only).get<humanlike::PadDirection>().weight, 0);
  EXPECT_EQ(made(MapMode::fingertip_only).get<humanlike::HandOrientation>().weight, 0);
  EXPECT_GT(made(MapMode::joint_to_joint).get<humanlike::ChainPosition>().weight, 0);
  EXPECT_GT(made(MapMode::joint_to_joint).get<humanlike::JointAngle>().weight, 0);
}

TEST(MapOptions, RefusesWhatMakesNoSense) {
  EXPECT_EQ(validation_error(MapOptions{}), "");
  MapOptions options;
  options.objective.get<humanlike::ThumbDistance>().full_distance_m = 1;
  EXPECT_THAT(validation_error(options), HasSubstr("less than thumb_zero_distance"));
}

/// The weights do what they say: an arm with joints to spare and the same wrist goal, with B or C
/// weighted, has less of it than without any humanlikeness.
TEST(MapOptions, TrianglesAndHullsAreLessWhereTheyCount) {
  const robot::Robot robot(robot::generate_arm({12, 0.6}));
  Goals goals;
  constexpr std::size_t kFrames = 8;
  goals.tip_position = {kFrames, 1, Vec3(0.25, 0.2, 0.2)};
  goals.tip_orientation = {kFrames, 1, unknown_rotation()};
  goals.reachable = {kFrames, 1, 0};
  goals.finger_joint_position = {kFrames, kFingerCount, unknown_point()};
  for (std::size_t f = 0; f < kFrames; ++f) {
    goals.time.push_back(0.01 * static_cast<double>(f));
    goals.shoulder_position.push_back(Vec3::Zero());
    goals.elbow_position.emplace_back(0.3, 0, 0);
    goals.wrist_position.emplace_back(0.25, 0.2, 0.2);
    goals.wrist_orientation.push_back(unknown_rotation());
  }
  const Scene scene;
  const collision::CollisionWorld world = collision::make_world(robot, scene, {}, {});
  const auto metrics = [&](double a, double b, double c) {
    MapOptions options;
    options.objective.get<humanlike::JointDistance>().weight = a;
    options.objective.get<humanlike::TriangleArea>().weight = b;
    options.objective.get<humanlike::HullVolume>().weight = c;
    options.starts = 24;
    options.reach_search_starts = 1;
    const MapResult result =
        map_movement(make_mapping_problem(robot, goals, world, options), goals, options, 1).value;
    EXPECT_LT(result.mapped.tip_error.maxCoeff(), 1e-3);
    return Vec3(result.mapped.humanlikeness.row(4).transpose());
  };
  const Vec3 none = metrics(0, 0, 0), b = metrics(0, 1, 0), c = metrics(0, 0, 10);
  EXPECT_LT(b[1], 0.5 * none[1]);
  EXPECT_LT(c[2], 0.5 * none[2]);
}

TEST(CompassSearch, FindsABowlsBottomInsideTheBox) {
  const Vec3 bottom(0.02, -0.031, 0.2);
  const auto bowl = [&](const Vec3& at) {
    const Vec3 away = at - bottom;
    return away.squaredNorm() + 0.5 * away.x() * away.y();
  };
  const Vec3 found = compass_search(bowl, 0.08, 1e-4);
  EXPECT_NEAR(found.x(), bottom.x(), 2e-4);
  EXPECT_NEAR(found.y(), bottom.y(), 2e-4);
  EXPECT_EQ(found.z(), 0.08);  // the box ends here
  EXPECT_EQ(compass_search([](const Vec3&) { return 1.0; }, 0.08, 1e-3), Vec3::Zero());
}

}  // namespace
}  // namespace morphe::map
