#include <gmock/gmock.h>

#include <set>

#include "stages/import/audit/checks.hpp"
#include "tests/stages/import/audit/table_trials.hpp"

namespace morphe::imports {
namespace {

using testing::IsEmpty;

/// Every trial with the static trial of each other person; subjects are not compared.
TEST(AuditStatic, AnotherPersonsTrialIsFoundByItsGeometry) {
  int found = 0, pairs = 0;
  for (const Demonstration& trial : table_trials()) {
    EXPECT_THAT(check_static_trial(trial, {}), IsEmpty()) << trial.name;
    for (const Demonstration& other : table_trials()) {
      if (other.subject == trial.subject) continue;
      Demonstration mixed = trial;
      mixed.calibration = other.calibration;
      const std::vector<Doubt> doubts = check_static_trial(mixed, {});
      ++pairs;
      found += !doubts.empty() && doubts[0].flag.code == FlagCode::static_trial;
    }
  }
  EXPECT_GE(found, pairs * 8 / 10);  // the plates are the same; one person is like another
}

TEST(AuditStatic, ATrialThatNamesAnotherPersonIsFlagged) {
  const std::filesystem::path folder = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl";
  const auto flags_with = [&](const char* static_trial) {
    ImportRequest request;
    request.paths = {folder / "ADL006DR2.csv"};
    request.static_trial = folder / static_trial;
    std::set<FlagCode> codes;
    import_recordings(request, [&](Demonstration&& d) {
      for (const RecordingFlag& flag : d.flags) codes.insert(flag.code);
    });
    return codes;
  };
  EXPECT_THAT(flags_with("ADL006_static.csv"), IsEmpty());
  EXPECT_TRUE(flags_with("ADL004_static.csv").contains(FlagCode::static_trial));
  EXPECT_TRUE(flags_with("ADL001_static.csv").contains(FlagCode::static_trial));
}

TEST(AuditStatic, AMarkerThatWasMovedChangesTheCluster) {
  Demonstration trial = table_trials()[0];
  MarkerStream& still = *trial.calibration.markers;
  const auto column = std::ranges::find(still.names, "RUAR2") - still.names.begin();
  for (std::size_t i = 0; i < still.position.rows; ++i) still.position(i, column).x() += 0.03;
  const std::vector<Doubt> doubts = check_static_trial(trial, {});
  ASSERT_FALSE(doubts.empty());
  EXPECT_EQ(doubts[0].flag.subject, "RUAR");
}

TEST(AuditStatic, AClusterThatOnlyTheStaticTrialShowsIsNamed) {
  for (const std::string cluster : {"RSHO", "LSHO", "RUAR", "RLAR", "RHAN"}) {
    Demonstration trial = table_trials()[0];
    MarkerStream& markers = *trial.streams.markers;
    for (std::size_t k = 0; k < markers.names.size(); ++k) {
      if (!markers.names[k].starts_with(cluster)) continue;
      for (std::size_t i = 0; i < markers.position.rows; ++i)
        markers.position(i, k) = unknown_point();
    }
    const std::vector<Doubt> doubts = check_static_trial(trial, {});
    ASSERT_THAT(doubts, testing::SizeIs(1)) << cluster;
    EXPECT_EQ(doubts[0].flag.code, FlagCode::static_trial);
    EXPECT_THAT(doubts[0].flag.text,
                testing::StartsWith(cluster + "1 is in the static trial, not in the recording"));
  }
}

}  // namespace
}  // namespace morphe::imports
