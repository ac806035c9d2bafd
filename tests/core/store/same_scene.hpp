#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/motion/scene.hpp"
#include "same_bits.hpp"

namespace morphe::store {

inline void expect_same(const std::vector<SceneObject>& all_a,
                        const std::vector<SceneObject>& all_b) {
  ASSERT_EQ(all_a.size(), all_b.size());
  for (std::size_t i = 0; i < all_a.size(); ++i) {
    const SceneObject &a = all_a[i], &b = all_b[i];
    EXPECT_SAME(name);
    EXPECT_SAME(shape);
    EXPECT_SAME(size);
    EXPECT_SAME(time);
    EXPECT_SAME(position);
    EXPECT_SAME(orientation);
    EXPECT_SAME(vertices);
    EXPECT_SAME(triangles);
    EXPECT_SAME(attached_frame);
    EXPECT_SAME(attach_s);
    EXPECT_SAME(release_s);
    EXPECT_SAME(pose_origin);
    EXPECT_SAME(shape_origin);
  }
}

}  // namespace morphe::store
