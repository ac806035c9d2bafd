#pragma once

#include <gtest/gtest.h>

#include "core/motion/geometry.hpp"

namespace morphe {

inline void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_LT((a - b).norm(), 1e-12) << a.transpose() << " against " << b.transpose();
}

}  // namespace morphe
