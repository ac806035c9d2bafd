#include "pipeline/place/stand.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphe::place {
namespace {

/// The angle of the base's axis to the nearest of a mount's directions.
double lean(Mount mount, const Vec3& up) {
  switch (mount) {
    case Mount::any:
      break;
    case Mount::floor:
      return std::acos(std::min(1.0, up.z()));
    case Mount::ceiling:
      return std::acos(std::min(1.0, -up.z()));
    case Mount::wall:
      return std::abs(std::asin(up.z()));
    case Mount::side:
      return std::acos(std::min(1.0, std::abs(up.x())));
  }
  return 0;
}

TEST(Stand, ItsPlacementTurnsTheBaseAsItStands) {
  math::RandomStream random(3, "test");
  PlaceOptions options;
  for (int k = 0; k < 200; ++k) {
    const Stand stand = random_stand({}, options, random);
    const Stand back = stand_of(placement_of(stand));
    EXPECT_LT(angle_between(stand.world_from_base, back.world_from_base), 0.2 * kDegree);
    EXPECT_LT((stand.shoulder_offset - back.shoulder_offset).cwiseAbs().maxCoeff(), 0.000501);
  }
  // Where z and x turn about one line, and nothing is to be turned.
  for (const double y : {90.0, -90.0}) {
    Stand stand;
    stand.world_from_base = Eigen::AngleAxisd(0.4, Vec3::UnitZ()) *
                            Eigen::AngleAxisd(y * kDegree, Vec3::UnitY()) *
                            Eigen::AngleAxisd(0.3, Vec3::UnitX());
    const Stand back = stand_of(placement_of(stand));
    EXPECT_LT(angle_between(stand.world_from_base, back.world_from_base), 0.2 * kDegree);
  }
  EXPECT_TRUE(placement_of({}).rotation.empty());
}

TEST(Stand, WhatIsDrawnAndWhatIsAllowedKeepTheMount) {
  math::RandomStream random(5, "test");
  for (const Mount mount : {Mount::floor, Mount::ceiling, Mount::wall, Mount::side}) {
    for (const double tilt : {0.0, 0.3}) {
      PlaceOptions options;
      options.mount = mount;
      options.tilt_rad = tilt;
      for (int k = 0; k < 100; ++k) {
        EXPECT_LE(lean(mount, random_stand({}, options, random).up()), tilt + 1e-6);
        Stand any;
        any.world_from_base = random.rotation();
        const Stand kept = allowed(any, {}, options);
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
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  constexpr int kMany = 20000;
  for (int k = 0; k < kMany; ++k) {
    const Vec3 up = random_stand({}, {}, random).up();
    sum += up / kMany;
    squares += up * up.transpose() / kMany;
  }
  EXPECT_LT(sum.norm(), 0.03);
  EXPECT_LT((squares - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 0.02);
}

TEST(Stand, WhatIsKeptStays) {
  Stand configured;
  configured.shoulder_offset = {0.9, 0.1, -0.2};
  configured.world_from_base = Eigen::AngleAxisd(0.4, Vec3::UnitY());
  PlaceOptions options;
  options.mount = Mount::ceiling;
  options.keep = {true, false, true, true};
  math::RandomStream random(9, "test");
  const Stand stand = random_stand(configured, options, random);
  EXPECT_EQ(stand.shoulder_offset.x(), 0.9);
  EXPECT_NE(stand.shoulder_offset.y(), 0.1);
  EXPECT_EQ(stand.shoulder_offset.z(), -0.2);
  EXPECT_EQ(angle_between(stand.world_from_base, configured.world_from_base), 0);
}

TEST(PlaceOptions, SayWhatIsWrong) {
  PlaceOptions options;
  EXPECT_EQ(why_invalid(options), "");
  options.tilt_rad = 2;
  EXPECT_NE(why_invalid(options), "");
  options = {};
  options.planned = options.refined + 1;
  EXPECT_NE(why_invalid(options), "");
}

}  // namespace
}  // namespace morphe::place
