#include "pipeline/place/base_placement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/place/constants.hpp"

namespace morphe::place {
namespace {

/// The angle of the base's axis to the nearest of a mount's directions.
double lean(MountDirection mount, const Vec3& up) {
  switch (mount) {
    case MountDirection::any:
      break;
    case MountDirection::floor:
      return std::acos(std::min(1.0, up.z()));
    case MountDirection::ceiling:
      return std::acos(std::min(1.0, -up.z()));
    case MountDirection::wall:
      return std::abs(std::asin(up.z()));
    case MountDirection::side:
      return std::acos(std::min(1.0, std::abs(up.x())));
  }
  return 0;
}

TEST(Stand, ItsPlacementTurnsTheBaseAsItStands) {
  math::RandomStream random(3, "test");
  PlaceOptions options;
  options.mount = MountDirection::any;
  for (int k = 0; k < 200; ++k) {
    const BasePlacement stand = random_base_placement({}, options, random);
    const BasePlacement back = base_placement_of(placement_of(stand));
    EXPECT_LT(angle_between(stand.world_from_base, back.world_from_base), 0.2 * kRadPerDegree);
    EXPECT_LT((stand.shoulder_offset - back.shoulder_offset).cwiseAbs().maxCoeff(), 0.000501);
  }
  // Where z and x turn about one line, and nothing is to be turned.
  for (const double y : {90.0, -90.0}) {
    BasePlacement stand;
    stand.world_from_base = Eigen::AngleAxisd(0.4, Vec3::UnitZ()) *
                            Eigen::AngleAxisd(y * kRadPerDegree, Vec3::UnitY()) *
                            Eigen::AngleAxisd(0.3, Vec3::UnitX());
    const BasePlacement back = base_placement_of(placement_of(stand));
    EXPECT_LT(angle_between(stand.world_from_base, back.world_from_base), 0.2 * kRadPerDegree);
  }
  EXPECT_TRUE(placement_of({}).rotation.empty());
}

TEST(Stand, WhatIsDrawnAndWhatIsAllowedKeepTheMount) {
  math::RandomStream random(5, "test");
  for (const MountDirection mount : {MountDirection::floor, MountDirection::ceiling,
                                     MountDirection::wall, MountDirection::side}) {
    for (const double tilt : {0.0, 0.3}) {
      PlaceOptions options;
      options.mount = mount;
      options.max_tilt_rad = tilt;
      for (int k = 0; k < 100; ++k) {
        EXPECT_LE(lean(mount, random_base_placement({}, options, random).up()), tilt + 1e-6);
        BasePlacement any;
        any.world_from_base = random.rotation();
        const BasePlacement kept = project_to_constraints(any, {}, options);
        EXPECT_LE(lean(mount, kept.up()), tilt + 1e-6);
        // By no more than it has to.
        const double turned = angle_between(any.world_from_base, kept.world_from_base);
        EXPECT_NEAR(turned, std::max(0.0, lean(mount, any.up()) - tilt), 1e-6);
      }
    }
  }
}

TEST(Stand, AnyAxisIsAsLikelyAsAnother) {
  math::RandomStream random(7, "test");
  PlaceOptions options;
  options.mount = MountDirection::any;
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  constexpr int kMany = 20000;
  for (int k = 0; k < kMany; ++k) {
    const Vec3 up = random_base_placement({}, options, random).up();
    sum += up / kMany;
    squares += up * up.transpose() / kMany;
  }
  EXPECT_LT(sum.norm(), 0.03);
  EXPECT_LT((squares - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 0.02);
}

TEST(Stand, WhatIsKeptStays) {
  BasePlacement configured;
  configured.shoulder_offset = {0.9, 0.1, -0.2};
  configured.world_from_base = Eigen::AngleAxisd(0.4, Vec3::UnitY());
  PlaceOptions options;
  options.mount = MountDirection::ceiling;
  options.fixed = {true, false, true, true};
  math::RandomStream random(9, "test");
  const BasePlacement stand = random_base_placement(configured, options, random);
  EXPECT_EQ(stand.shoulder_offset.x(), 0.9);
  EXPECT_NE(stand.shoulder_offset.y(), 0.1);
  EXPECT_EQ(stand.shoulder_offset.z(), -0.2);
  EXPECT_EQ(angle_between(stand.world_from_base, configured.world_from_base), 0);
}

TEST(Stand, ABaseStandsUprightUnlessAnotherMountIsAskedFor) {
  math::RandomStream random(11, "test");
  for (int k = 0; k < 50; ++k)
    EXPECT_NEAR(random_base_placement({}, {}, random).up().z(), 1, 1e-12);
}

/// Returns the angle between the robot's forward direction, without its height, and the person's.
double turned_away(const robot::Standing& standing, const BasePlacement& stand) {
  const Vec3 forward = stand.world_from_base * standing.forward;
  return std::abs(std::atan2(forward.x(), forward.y()));
}

TEST(Stand, ARobotWithABodyFacesThePersonsWayAlsoIfItsUpIsAnotherAxis) {
  PlaceOptions options;
  math::RandomStream random(13, "test");
  for (const robot::Standing& standing :
       {robot::Standing{Vec3::UnitZ(), Vec3::UnitX(), "torso"},
        robot::Standing{Vec3::UnitY(), -Vec3::UnitX(), "left_leg"}}) {
    options.standing = standing;
    double smallest = 1, largest = 0;
    for (int k = 0; k < 100; ++k) {
      const BasePlacement drawn = random_base_placement({}, options, random);
      EXPECT_NEAR(drawn.up(standing.up).z(), 1, 1e-9);
      EXPECT_LE(turned_away(standing, drawn), kMaxFacingAngle_rad + 1e-9);
      smallest = std::min(smallest, turned_away(standing, drawn));
      largest = std::max(largest, turned_away(standing, drawn));
      BasePlacement any;
      any.world_from_base = random.rotation();
      const BasePlacement kept = project_to_constraints(any, {}, options);
      EXPECT_NEAR(kept.up(standing.up).z(), 1, 1e-9);
      EXPECT_LE(turned_away(standing, kept), kMaxFacingAngle_rad + 1e-9);
    }
    EXPECT_LT(smallest, 0.05) << "straight ahead is drawn";
    EXPECT_GT(largest, 0.9 * kMaxFacingAngle_rad);
    options.mount = MountDirection::any;
    double farthest = 0;
    for (int k = 0; k < 100; ++k)
      farthest =
          std::max(farthest, turned_away(standing, random_base_placement({}, options, random)));
    EXPECT_GT(farthest, 2) << "any direction is any direction";
    options.mount = MountDirection::floor;
  }
}

TEST(PlaceOptions, SayWhatIsWrong) {
  PlaceOptions options;
  EXPECT_EQ(validation_error(options), "");
  options.max_tilt_rad = 2;
  EXPECT_NE(validation_error(options), "");
  options = {};
  options.plan = options.refine + 1;
  EXPECT_NE(validation_error(options), "");
}

}  // namespace
}  // namespace morphe::place
