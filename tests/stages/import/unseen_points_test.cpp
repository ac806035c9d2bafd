#include "stages/import/recording/unseen_points.hpp"

#include <gmock/gmock.h>

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Points of one marker in metres, from numbers in units of `unit_m`.
Array2D<Vec3> points_in(double unit_m, const std::vector<Vec3>& points) {
  Array2D<Vec3> position(points.size(), 1, Vec3::Zero());
  for (std::size_t i = 0; i < points.size(); ++i) position(i, 0) = unit_m * points[i];
  return position;
}

std::vector<bool> seen(const Array2D<Vec3>& position) {
  std::vector<bool> known;
  for (const Vec3& point : position.values) known.push_back(is_known(point));
  return known;
}

TEST(UnseenPoints, NinesAreFillersInEveryUnit) {
  for (const double unit_m : {1.0, 0.01, 0.001, 0.0254}) {
    for (const double nines : {-9999.0, 9999.0, -999.0, 999.9, -99999.0, 9999.99}) {
      auto position = points_in(unit_m, {{1, 2, 3}, Vec3::Constant(nines), {2, 3, 4}});
      std::vector<std::string> notes;
      hide_fillers(unit_m, position, notes);
      EXPECT_THAT(seen(position), ElementsAre(true, false, true)) << nines << " " << unit_m;
      EXPECT_THAT(notes, ElementsAre(fmt::format("{:.7g} stands in 3 cells; treated as not visible",
                                                 nines)));
    }
  }
}

TEST(UnseenPoints, NinesInOneCoordinateAreFillersOnlyFarFromAllOthers) {
  std::vector<std::string> notes;
  auto position = points_in(0.001, {{100, -9999, 300}, {101, 200, 301}});
  hide_fillers(0.001, position, notes);
  EXPECT_THAT(seen(position), ElementsAre(false, true));
  EXPECT_THAT(notes, ElementsAre("-9999 stands in 1 cell; treated as not visible",
                                 "1 point has only some of x, y, z; treated as not visible"));
  notes.clear();
  position = points_in(0.001, {{999, 200, 300}, {998, 200, 300}});  // a place
  hide_fillers(0.001, position, notes);
  EXPECT_THAT(seen(position), ElementsAre(true, true));
  EXPECT_THAT(notes, IsEmpty());
}

TEST(UnseenPoints, FloatsAndHugeNumbers) {
  std::vector<std::string> notes;
  auto position = points_in(
      0.001,
      {{double{9999.99F}, double{9999.99F}, double{9999.99F}}, Vec3::Constant(3.4e38), {1, 2, 3}});
  hide_fillers(0.001, position, notes);
  EXPECT_THAT(seen(position), ElementsAre(false, false, true));
}

TEST(UnseenPoints, MinusOneIsAFillerOfAPointThatWasElsewhere) {
  std::vector<std::string> notes;
  auto moving = points_in(1, {{0.1, 0.2, 0.3}, {-1, -1, -1}});
  hide_fillers(1, moving, notes);
  EXPECT_THAT(seen(moving), ElementsAre(true, false));
  auto resting = points_in(1, {{-1, -1, -1}, {-1, -1, -1}});
  hide_fillers(1, resting, notes);
  EXPECT_THAT(seen(resting), ElementsAre(true, true));
}

}  // namespace
}  // namespace morphe::imports
