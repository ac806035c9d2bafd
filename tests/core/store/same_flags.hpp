#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/motion/recording_flag.hpp"
#include "same_bits.hpp"

namespace morphe::store {

/// Expects that both have the same flags, bit for bit.
inline void expect_same(const std::vector<RecordingFlag>& all_a,
                        const std::vector<RecordingFlag>& all_b) {
  ASSERT_EQ(all_a.size(), all_b.size());
  for (std::size_t i = 0; i < all_a.size(); ++i) {
    const RecordingFlag &a = all_a[i], &b = all_b[i];
    EXPECT_SAME(code);
    EXPECT_SAME(response);
    EXPECT_SAME(begin_s);
    EXPECT_SAME(end_s);
    EXPECT_SAME(subject);
    EXPECT_SAME(value);
    EXPECT_SAME(limit);
    EXPECT_SAME(unit);
    EXPECT_SAME(text);
  }
}

}  // namespace morphe::store
