#include "stages/repair/transit.hpp"

#include <gmock/gmock.h>

#include "tests/stages/repair/planar_arm.hpp"

namespace morphe::repair {
namespace {

using test::Bench;
using test::post;

const JointVector kHome = Vec3(-0.9, 0.3, 0.3), kStart = Vec3(0.9, 0.3, 0.3);

JointPath transfer(const Bench& bench, std::uint64_t seed = 1) {
  return plan_transit(bench.world, kHome, kStart, 0.5, RepairOptions{}, seed);
}

TEST(Transfer, GoesStraightWhereNothingStands) {
  const Bench bench({});
  const JointPath path = transfer(bench);
  ASSERT_GT(path.position.rows(), 20);
  for (Eigen::Index k = 0; k < path.position.rows(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(path.position.rows() - 1);
    EXPECT_LT((path.position.row(k).transpose() - kHome - share * (kStart - kHome)).norm(), 1e-9);
  }
}

TEST(Transfer, GoesAroundAPostInSmallSteps) {
  const Bench bench({post("post", 0.9, 0)});
  const JointPath path = transfer(bench);
  ASSERT_GT(path.position.rows(), 20);
  EXPECT_EQ(path.position.row(0).transpose(), kHome);
  EXPECT_EQ(path.position.bottomRows(1).transpose(), kStart);
  EXPECT_TRUE(bench.collisions(path).empty());
  EXPECT_THAT(path.origin, testing::Each(SampleOrigin::planned));
  for (Eigen::Index k = 1; k < path.position.rows(); ++k) {
    EXPECT_LT((path.position.row(k) - path.position.row(k - 1)).cwiseAbs().maxCoeff(), 0.1);
  }
  EXPECT_EQ(path.position, transfer(bench).position);
}

TEST(Transfer, FindsNothingWhereItsEndIsInCollision) {
  EXPECT_EQ(transfer(Bench({post("on it", 0.321, 0.5)})).position.rows(), 0);
}

}  // namespace
}  // namespace morphe::repair
