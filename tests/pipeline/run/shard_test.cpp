#include "pipeline/run/shard.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

using testing::ElementsAre;

TEST(Shard, IsReadAndWritten) {
  EXPECT_EQ(parse_shard("3/16"), (Shard{3, 16}));
  EXPECT_EQ(shard_text({3, 16}), "3/16");
  for (const char* text :
       {"", "3", "0/3", "4/3", "-1/3", "1/0", "1/3/5", "1 /3", "a/b", "1/9999999"}) {
    EXPECT_THAT([&] { parse_shard(text); },
                testing::ThrowsMessage<InputError>(testing::StrEq(
                    fmt::format("--shard {}: must be I/N with 1 <= I <= N, or slurm", text))));
  }
}

TEST(Shard, TheLongestGoesToTheEmptiest) {
  // 9 -> 1, 7 -> 2, 5 -> 2 (12), 4 -> 1 (13), 2 -> 2 (14), 1 -> 1 (14)
  EXPECT_THAT(assign_shards({1, 9, 5, 2, 7, 4}, 2), ElementsAre(1, 1, 2, 2, 2, 1));
  EXPECT_THAT(assign_shards({0, 0, 0, 0}, 3), ElementsAre(1, 2, 3, 1));
  EXPECT_THAT(assign_shards({5, 5}, 4), ElementsAre(1, 2));
  EXPECT_THAT(assign_shards({}, 4), ElementsAre());
}

TEST(Shard, LoadsDifferByAtMostTheLongest) {
  std::vector<std::size_t> frames;
  for (std::size_t i = 0; i < 1000; ++i) frames.push_back(100 + i * i * 7919 % 3001);
  for (const int count : {2, 7, 64}) {
    const std::vector<int> shard_of = assign_shards(frames, count);
    std::vector<std::size_t> loads(static_cast<std::size_t>(count), 0);
    for (std::size_t i = 0; i < frames.size(); ++i) loads.at(shard_of[i] - 1) += frames[i];
    const auto [least, most] = std::minmax_element(loads.begin(), loads.end());
    EXPECT_LE(*most - *least, *std::max_element(frames.begin(), frames.end())) << count;
  }
}

}  // namespace
}  // namespace morphe::run
