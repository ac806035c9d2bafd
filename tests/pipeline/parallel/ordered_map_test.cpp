#include "pipeline/parallel/ordered_map.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace morphe::parallel {
namespace {

/// Items 1 … count, each squared by as many tasks as it counts; how they were written.
std::vector<int> squares(int count, int jobs) {
  std::vector<int> written;
  int given = 0;
  OrderedMap<int, int> map;
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
  EXPECT_THROW(for_each_index(8,
                              [](std::size_t k) {
                                if (k == 5) throw std::runtime_error("five");
                              }),
               std::runtime_error);
  for_each_index(0, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace morphe::parallel
