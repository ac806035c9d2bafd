#include "stages/import/audit/exchanges.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>
#include <vector>

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kRate_hz = 100;

/// Three points that move along a line at up to 1 m/s, 60 mm and 90 mm beside each other.
struct Points {
  std::vector<double> time;
  Array2D<Vec3> position;

  explicit Points(double rate_hz = kRate_hz, std::size_t frames = 200)
      : position(frames, 3, unknown_point()) {
    for (std::size_t i = 0; i < frames; ++i) {
      time.push_back(static_cast<double>(i) / rate_hz);
      const double along_m = 0.3 * (1 - std::cos(3 * time.back()));
      position(i, 0) = {along_m, 0, 0};
      position(i, 1) = {along_m, 0.06, 0.01 * std::sin(5 * time.back())};
      position(i, 2) = {along_m, 0.09, 0};
    }
  }
  void exchange(std::size_t a, std::size_t b, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) std::swap(position(i, a), position(i, b));
  }
};

TEST(Exchanges, NoneInPointsThatMoveOn) {
  const Points points;
  EXPECT_THAT(find_exchanges(points.time, points.position), IsEmpty());
}

TEST(Exchanges, FoundAtTheirFrameAndUndone) {
  const Points truth;
  Points points;
  points.exchange(0, 1, 130, 200);
  const auto exchanges = find_exchanges(points.time, points.position);
  ASSERT_EQ(exchanges.size(), 1);
  EXPECT_EQ(exchanges[0].frame, 130);
  EXPECT_THAT(exchanges[0].source, ElementsAre(1, 0, 2));
  EXPECT_EQ(undo_exchanges(exchanges, points.position).values, truth.position.values);
  EXPECT_THAT(source_at(exchanges, 129, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(source_at(exchanges, 130, 3), ElementsAre(1, 0, 2));
}

TEST(Exchanges, OfAnIntervalAndOfOneFrameEnd) {
  for (const std::size_t end : {101, 150}) {
    const Points truth;
    Points points;
    points.exchange(1, 2, 100, end);
    const auto exchanges = find_exchanges(points.time, points.position);
    ASSERT_EQ(exchanges.size(), 2);
    EXPECT_EQ(exchanges[1].frame, end);
    EXPECT_EQ(undo_exchanges(exchanges, points.position).values, truth.position.values);
  }
}

TEST(Exchanges, OfThreePointsAndAtVideoRate) {
  for (const double rate_hz : {100.0, 30.0}) {
    const Points truth(rate_hz);
    Points points(rate_hz);
    points.exchange(0, 1, 70, 200);
    points.exchange(1, 2, 70, 200);
    const auto exchanges = find_exchanges(points.time, points.position);
    ASSERT_EQ(exchanges.size(), 1);
    EXPECT_THAT(cycles_of(exchanges[0].source), ElementsAre(ElementsAre(0, 2, 1)));
    EXPECT_EQ(undo_exchanges(exchanges, points.position).values, truth.position.values);
  }
}

TEST(Exchanges, NoneInASpikeAStepOrPathsThatCross) {
  Points points;
  points.position(60, 0) += Vec3(0, 0, 0.2);
  for (std::size_t i = 120; i < 200; ++i) points.position(i, 1) += Vec3(0, 0.1, 0);
  EXPECT_THAT(find_exchanges(points.time, points.position), IsEmpty());
  Points crossing;
  for (std::size_t i = 0; i < 200; ++i) {
    crossing.position(i, 0).y() = 0.5 * (crossing.time[i] - 1);
    crossing.position(i, 1) = {crossing.position(i, 0).x(), 0.5 * (1 - crossing.time[i]), 0};
  }
  EXPECT_THAT(find_exchanges(crossing.time, crossing.position), IsEmpty());
}

}  // namespace
}  // namespace morphe::imports
