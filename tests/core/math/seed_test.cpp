#include "core/math/seed.hpp"

#include <gtest/gtest.h>

namespace morphe::math {
namespace {

TEST(Seed, IsTheFirstBytesOfTheHash) {
  // printf '7/reach' | sha256sum
  EXPECT_EQ(seed_from(7, "reach"), 0xaada4facb0201066u);
  EXPECT_NE(seed_from(7, "reach"), seed_from(8, "reach"));
  EXPECT_NE(seed_from(7, "reach"), seed_from(7, "grasp"));
  EXPECT_EQ(seed_from(7, "reach", 2), seed_from(7, "reach/2"));
}

}  // namespace
}  // namespace morphe::math
