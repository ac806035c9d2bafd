#include <gtest/gtest.h>

#include "tests/core/collision/random_pairs.hpp"

namespace morphe::collision {
namespace {

class DistanceTruth : public testing::TestWithParam<Shape> {};

/// 10^4 pairs of all shapes together; bench_collision --pairs N does any number.
TEST_P(DistanceTruth, IsNeverOverestimated) {
  RandomBodies random(71);
  DistanceError worst;
  for (int k = 0; k < 2000; ++k) {
    const DistanceError error = random_pair_error(random, GetParam(), k);
    worst.over = std::max(worst.over, error.over);
    worst.under = std::max(worst.under, error.under);
    worst.uncertain = std::max(worst.uncertain, error.uncertain);
  }
  EXPECT_LT(worst.over, 1e-9);
  EXPECT_LT(worst.under, 1e-9);
  EXPECT_LT(worst.uncertain, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Shapes, DistanceTruth,
                         testing::Values(Shape::sphere, Shape::box, Shape::cylinder, Shape::capsule,
                                         Shape::mesh),
                         [](const auto& shape) { return std::string(name_of(shape.param)); });

}  // namespace
}  // namespace morphe::collision
