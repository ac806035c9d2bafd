#include "tests/core/collision/thin_walls.hpp"

#include <gtest/gtest.h>

namespace morphe::collision {
namespace {

/// bench_collision --walls N does any number.
TEST(ThinWalls, NoCollisionIsMissedAndNoRoomRefused) {
  RandomBodies random(72);
  CollisionScratch scratch;
  ThinWallCount count;
  for (int k = 0; k < 100; ++k) count_thin_walls(random, count, scratch);
  EXPECT_EQ(count.missed, 0);
  EXPECT_EQ(count.refused, 0);
  EXPECT_GT(count.clear, 20);
  EXPECT_GT(count.colliding, 5);
}

}  // namespace
}  // namespace morphe::collision
