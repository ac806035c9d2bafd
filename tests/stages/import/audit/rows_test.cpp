// Rows that were written more often or lost, told apart from rows in which the points were held and
// from spikes.
#include <gmock/gmock.h>

#include "tests/stages/import/audit/checks_alone.hpp"
#include "tests/stages/import/audit/recorded_reach.hpp"

namespace morphe::imports {
namespace {

using testing::Each;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

/// Writes every `every`-th row twice; later rows come later.
Demonstration with_rows_twice(std::size_t every) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  const Array2D<Vec3> before = markers.position;
  markers.time.clear();
  markers.position.values.clear();
  for (std::size_t i = 0; i < before.rows; ++i) {
    for (int copy = i % every == 0 ? 0 : 1; copy < 2; ++copy) {
      for (std::size_t k = 0; k < before.cols; ++k) markers.position.values.push_back(before(i, k));
      markers.time.push_back(0.01 * static_cast<double>(markers.time.size()));
    }
  }
  markers.position.rows = markers.time.size();
  return recording;
}

TEST(AuditRows, AddedRowsMakeTheRecordingSlowerAndAreFlagged) {
  for (const std::size_t every : {1, 2, 3, 10}) {
    const std::vector<Doubt> doubts = check_rows(with_rows_twice(every), {});
    ASSERT_THAT(doubts, SizeIs(1)) << every;
    EXPECT_EQ(doubts[0].flag.code, FlagCode::repeated_rows);
    EXPECT_FALSE(doubts[0].mend) << "hiding them would leave the times wrong";
    EXPECT_THAT(doubts[0].flag.text, HasSubstr("remove them"));
  }
}

TEST(AuditRows, RowsThatTheCameraMissedAreHidden) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  for (std::size_t i = 120; i < 180; i += 7) {
    for (std::size_t k = 0; k < markers.names.size(); ++k)
      markers.position(i, k) = markers.position(i - 1, k);
  }
  const std::vector<Doubt> doubts = check_rows(recording, {});
  ASSERT_THAT(doubts, SizeIs(1));
  EXPECT_EQ(doubts[0].flag.code, FlagCode::repeated_rows);
  EXPECT_TRUE(doubts[0].mend);
}

TEST(AuditRows, SingleLostRowsCountIfThereAreSeveral) {
  Demonstration recording = recorded_reach();
  for (const std::size_t row : {165, 154, 149, 143, 138, 127})
    lose_rows(row, row + 1, *recording.streams.markers);
  const std::vector<Doubt> doubts = check_rows(recording, {});
  ASSERT_THAT(doubts, SizeIs(1)) << "one flag for all";
  EXPECT_EQ(doubts[0].flag.code, FlagCode::lost_rows);
  EXPECT_THAT(doubts[0].flag.text, HasSubstr("rows are missing before each jump"));
}

TEST(AuditRows, SpikesOfManyPointsAreNoLostRows) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  math::RandomStream random(11, "many spikes");
  for (std::size_t i = 0; i < markers.position.rows; ++i) {
    for (std::size_t k = 0; k < markers.names.size(); ++k) {
      if (random.uniform(0, 1) < 0.01) markers.position(i, k) += Vec3(0.06, 0, 0.08);
    }
  }
  EXPECT_THAT(check_rows(recording, {}), SizeIs(0));
  for (const Doubt& doubt : check_jumps(recording, {})) EXPECT_EQ(doubt.flag.code, FlagCode::spike);
}

}  // namespace
}  // namespace morphe::imports
