#include "core/parallel/ordered_parallel_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace morphe::parallel {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

/// Items 1 … count, each squared by as many tasks as it counts; how they were written.
std::vector<int> squares(int count, int jobs) {
  std::vector<int> written;
  int given = 0;
  OrderedParallelMap<int, int> map;
  map.next = [&] { return given < count ? std::make_unique<int>(++given) : nullptr; };
  map.work = [](const int& item) {
    std::vector<int> parts(static_cast<std::size_t>(item), 0);
    for_each_index(parts.size(), [&](std::size_t k) { parts[k] = item; });
    int sum = 0;
    for (const int part : parts) sum += part;
    return std::make_unique<int>(sum);
  };
  map.write = [&](const int& result) { written.push_back(result); };
  run(map, jobs);
  return written;
}

TEST(OrderedMap, WritesInOrderWhateverTheTasksInside) {
  for (const int jobs : {1, 2, 8}) {
    const std::vector<int> written = squares(60, jobs);
    ASSERT_EQ(written.size(), 60u);
    for (int k = 0; k < 60; ++k) EXPECT_EQ(written[static_cast<std::size_t>(k)], (k + 1) * (k + 1));
  }
}

TEST(OrderedMap, AnExceptionOfATaskIsThrownWhereItWasAskedFor) {
  EXPECT_THAT(
      [] {
        for_each_index(8, [](std::size_t k) {
          if (k == 5) throw std::runtime_error("five");
        });
      },
      ThrowsMessage<std::runtime_error>(StrEq("five")));
  for_each_index(0, [](std::size_t) { FAIL(); });
}

/// One that counts how many of its kind there are.
struct Counted {
  explicit Counted(std::atomic<int>& count) : alive(count) { ++alive; }
  ~Counted() { --alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  std::atomic<int>& alive;
};

enum class Where { next, work, write };

/// How many items and results are left of a run that the 30th call of one of the three ends.
int left_behind(Where where, int jobs) {
  std::atomic<int> alive{0}, calls{0};
  const auto called = [&](Where here) {
    if (here == where && ++calls == 30) throw std::runtime_error("thirty");
  };
  OrderedParallelMap<Counted, Counted> map;
  map.next = [&] {
    called(Where::next);
    return std::make_unique<Counted>(alive);
  };
  map.work = [&](const Counted&) {
    called(Where::work);
    return std::make_unique<Counted>(alive);
  };
  map.write = [&](const Counted&) { called(Where::write); };
  EXPECT_THAT([&] { run(map, jobs); }, ThrowsMessage<std::runtime_error>(StrEq("thirty")));
  return alive;
}

TEST(OrderedMap, AnExceptionLeavesNoItemBehind) {
  for (const Where where : {Where::next, Where::work, Where::write})
    for (const int jobs : {1, 2, 8})
      for (int k = 0; k < 20; ++k) ASSERT_EQ(left_behind(where, jobs), 0);
}

TEST(OrderedMap, NoMoreItemsAreAliveThanTwoForEachThread) {
  std::atomic<int> alive{0};
  int given = 0, most = 0;
  OrderedParallelMap<Counted, Counted> map;
  map.next = [&] {
    most = std::max(most, alive.load());
    return given++ < 200 ? std::make_unique<Counted>(alive) : nullptr;
  };
  map.work = [&](const Counted&) { return std::make_unique<Counted>(alive); };
  map.write = [](const Counted&) {};
  run(map, 2);
  EXPECT_EQ(alive, 0);
  EXPECT_LE(most, 4 + 2);  // and for each item in work its result beside it
}

}  // namespace
}  // namespace morphe::parallel
