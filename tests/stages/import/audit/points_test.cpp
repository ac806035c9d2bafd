// The audit's checks of rows, jumps, tempo and jitter: each damage is done to a recording whose
// truth is known, and the shipped recordings have none.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <string>

#include "stages/import/audit/audit.hpp"
#include "stages/import/audit/checks.hpp"
#include "tests/stages/import/audit/recorded_reach.hpp"
#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::imports {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::size_t kInReach = 145;  ///< a row at the fastest moment of the reach

/// Runs the checks of this test one after the other, as the audit does, and returns their flags.
std::vector<RecordingFlag> audited(Demonstration& recording, const AuditInput& input = {}) {
  const std::set<std::string> names = {"rows", "jumps", "time_base", "jitter"};
  for (const AuditCheck& check : audit_checks()) {
    if (!names.contains(check.name)) continue;
    StepTables steps;
    for (Doubt& doubt : check.find(recording, input, steps)) {
      doubt.flag.response = doubt.mend ? FlagResponse::mended : FlagResponse::flagged;
      if (doubt.mend) doubt.mend(recording);
      recording.flags.push_back(doubt.flag);
    }
  }
  return recording.flags;
}

/// Returns the only flag of a recording, or one with an empty text.
RecordingFlag only_flag(Demonstration& recording) {
  const std::vector<RecordingFlag> flags = audited(recording);
  EXPECT_EQ(flags.size(), 1U) << (flags.empty() ? "" : flags.back().text);
  return flags.size() == 1 ? flags[0] : RecordingFlag();
}

const Array2D<Vec3>& positions(const Demonstration& recording) {
  return recording.streams.markers->position;
}

/// Returns the number of samples that are seen in one array and not in the other.
std::size_t hidden_samples(const Array2D<Vec3>& before, const Array2D<Vec3>& after) {
  std::size_t count = 0;
  for (std::size_t n = 0; n < before.values.size(); ++n)
    count += is_known(before.values[n]) != is_known(after.values[n]) ? 1 : 0;
  return count;
}

TEST(AuditPoints, AnUndamagedReachHasNoFlag) {
  for (const double rate_hz : {30.0, 60.0, 100.0, 240.0}) {
    Demonstration recording = recorded_reach({.rate_hz = rate_hz});
    EXPECT_THAT(audited(recording), IsEmpty()) << rate_hz;
  }
}

TEST(AuditPoints, NoShippedRecordingHasAFlag) {
  const auto datasets = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets";
  for (const auto& folder : std::filesystem::directory_iterator(datasets)) {
    if (!std::filesystem::exists(folder.path() / "recordings.yaml")) continue;
    for (Demonstration& recording : shipped_recordings(folder.path().filename().string())) {
      recording.flags.clear();
      const std::vector<RecordingFlag> flags = audited(recording);
      EXPECT_THAT(flags, IsEmpty()) << recording.name << ": " << flags.front().text;
    }
  }
}

TEST(AuditPoints, ASpikeIsHiddenAndNothingElse) {
  for (const std::string name : {"RFTP", "RTHUM", "RHAN2"}) {
    for (const double size_m : {0.02, 0.2, 1.0}) {
      for (const std::size_t rows : {1, 2, 5}) {
        Demonstration recording = recorded_reach();
        MarkerStream& markers = *recording.streams.markers;
        const std::size_t k = column(recording, name);
        for (std::size_t i = kInReach; i < kInReach + rows; ++i)
          markers.position(i, k) += size_m * Vec3(0.6, 0, 0.8);
        const Array2D<Vec3> before = markers.position;
        const RecordingFlag flag = only_flag(recording);
        EXPECT_EQ(flag.code, FlagCode::spike);
        EXPECT_EQ(flag.response, FlagResponse::mended);
        EXPECT_EQ(flag.subject, name);
        EXPECT_NEAR(flag.value, size_m, 0.003);
        EXPECT_NEAR(flag.begin_s, markers.time[kInReach], 1e-9);
        EXPECT_EQ(hidden_samples(before, markers.position), rows);
        for (std::size_t i = kInReach; i < kInReach + rows; ++i)
          EXPECT_FALSE(is_known(markers.position(i, k)));
      }
    }
  }
}

TEST(AuditPoints, ASpikeOfAllPointsIsReportedOnce) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  for (std::size_t k = 0; k < markers.names.size(); ++k)
    markers.position(kInReach, k) += Vec3(0, 0.2, 0);
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::spike);
  EXPECT_EQ(flag.subject, "");
}

TEST(AuditPoints, AMarkerThatStaysAwayIsFlagged) {
  for (const double size_m : {0.02, 0.1}) {
    Demonstration recording = recorded_reach();
    MarkerStream& markers = *recording.streams.markers;
    const std::size_t k = column(recording, "RTHUM");
    for (std::size_t i = kInReach; i < markers.time.size(); ++i)
      markers.position(i, k) += Vec3(0, 0, size_m);
    const RecordingFlag flag = only_flag(recording);
    EXPECT_EQ(flag.code, FlagCode::step);
    EXPECT_EQ(flag.response, FlagResponse::flagged);
    EXPECT_EQ(flag.subject, "RTHUM");
    EXPECT_NEAR(flag.value, size_m, 0.002);
    EXPECT_TRUE(flag.overlaps(2, 3));
  }
}

TEST(AuditPoints, MarkersThatExchangePlacesAreNoSpike) {
  for (const std::size_t rows : {std::size_t{3}, std::size_t{1000}}) {
    Demonstration recording = recorded_reach();
    MarkerStream& markers = *recording.streams.markers;
    const std::size_t a = column(recording, "RTHUM"), b = column(recording, "RFTP");
    for (std::size_t i = kInReach; i < std::min(kInReach + rows, markers.time.size()); ++i)
      std::swap(markers.position(i, a), markers.position(i, b));
    EXPECT_THAT(audited(recording), IsEmpty()) << rows;
  }
}

TEST(AuditPoints, AFrozenMarkerIsHidden) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  const std::size_t k = column(recording, "RFTP");
  for (std::size_t i = kInReach + 1; i < kInReach + 30; ++i)
    markers.position(i, k) = markers.position(kInReach, k);
  const Array2D<Vec3> before = markers.position;
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::frozen_rows);
  EXPECT_EQ(flag.subject, "RFTP");
  EXPECT_EQ(hidden_samples(before, markers.position), 29U);
  EXPECT_TRUE(is_known(markers.position(kInReach, k)));
}

TEST(AuditPoints, FrozenRowsAreHiddenInAllPoints) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  const std::size_t points = markers.names.size();
  for (std::size_t i = kInReach + 1; i < kInReach + 15; ++i) {
    for (std::size_t k = 0; k < points; ++k) markers.position(i, k) = markers.position(kInReach, k);
  }
  const Array2D<Vec3> before = markers.position;
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::frozen_rows);
  EXPECT_EQ(flag.subject, "");
  EXPECT_EQ(hidden_samples(before, markers.position), 14 * points);
}

TEST(AuditPoints, JumpsAreLookedForInWhatTheCheckOfRowsLeft) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  for (std::size_t i = kInReach + 1; i < kInReach + 15; ++i) {
    for (std::size_t k = 0; k < markers.names.size(); ++k)
      markers.position(i, k) = markers.position(kInReach, k);
  }
  EXPECT_FALSE(audit_recording({}, recording));
  ASSERT_EQ(recording.flags.size(), 1U) << "the jump out of the frozen rows is no other doubt";
  EXPECT_EQ(recording.flags[0].code, FlagCode::frozen_rows);
}

TEST(AuditPoints, StandingStillExactlyIsNotFrozen) {
  Demonstration recording = recorded_reach({.noise_m = 0});
  EXPECT_THAT(audited(recording), IsEmpty());
}

TEST(AuditPoints, RowsWrittenTwiceAreHidden) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  const std::size_t points = markers.names.size();
  for (std::size_t i = kInReach; i < kInReach + 40; i += 2) {
    for (std::size_t k = 0; k < points; ++k) markers.position(i, k) = markers.position(i - 1, k);
  }
  const Array2D<Vec3> before = markers.position;
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::repeated_rows);
  EXPECT_GE(hidden_samples(before, markers.position), 18 * points);
}

TEST(AuditPoints, ABlockWrittenTwiceIsHidden) {
  Demonstration recording = recorded_reach();
  MarkerStream& markers = *recording.streams.markers;
  const auto row = static_cast<std::ptrdiff_t>(markers.names.size());
  auto& values = markers.position.values;
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(kInReach) * row;
  const std::vector<Vec3> block(begin, begin + 20 * row);
  values.insert(begin + 20 * row, block.begin(), block.end());
  for (int n = 0; n < 20; ++n) markers.time.push_back(markers.time.back() + 0.01);
  markers.position.rows += 20;
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::repeated_rows);
  EXPECT_NEAR(flag.begin_s, 0.01 * (kInReach + 20), 1e-9);
  EXPECT_EQ(flag.value, 20);
  EXPECT_FALSE(is_known(markers.position(kInReach + 20, 0)));
  EXPECT_TRUE(is_known(markers.position(kInReach + 19, 0)));
}

TEST(AuditPoints, LostRowsAreCountedAndLeft) {
  for (const std::size_t lost : {5, 20}) {
    Demonstration recording = recorded_reach();
    MarkerStream& markers = *recording.streams.markers;
    const std::size_t begin = kInReach - lost / 2;
    lose_rows(begin, begin + lost, markers);
    const std::vector<double> time = markers.time;
    const RecordingFlag flag = only_flag(recording);
    EXPECT_EQ(flag.code, FlagCode::lost_rows);
    EXPECT_EQ(flag.response, FlagResponse::flagged);
    EXPECT_NEAR(flag.end_s, time[begin], 1e-9);
    EXPECT_THAT(flag.text, testing::ContainsRegex(lost == 5 ? "about [4-6] rows"
                                                            : "about (1[89]|2[0-2]) rows"));
    EXPECT_EQ(markers.time, time) << "their number is an estimate";
  }
}

TEST(AuditPoints, AJumpToAnotherPlaceIsLostRowsOfUnknownNumber) {
  Demonstration recording = recorded_reach();
  lose_rows(80, 240, *recording.streams.markers);  // the whole reach
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::lost_rows);
  EXPECT_EQ(flag.response, FlagResponse::flagged);
}

TEST(AuditPoints, AHeaderWithThreeTimesTheRateIsDoubted) {
  Demonstration recording = recorded_reach({.rate_hz = 30, .duration_s = 0.8});
  for (double& time : recording.streams.markers->time) time *= 0.3;
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::time_base);
  EXPECT_THAT(flag.text, HasSubstr("--rate 30 "));
  AuditInput stated;
  stated.rate_given = true;
  EXPECT_THAT(check_time_base(recording, stated), IsEmpty());
}

TEST(AuditPoints, JitterOfTwoMillimetresIsFlagged) {
  Demonstration recording = recorded_reach({.noise_m = 0.002});
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::jitter);
  // White noise behind a zero-phase second-order Butterworth filter of 8 Hz at 100 Hz: 41 %.
  EXPECT_NEAR(flag.value, 0.41 * 0.002, 0.0001);
}

TEST(AuditPoints, EveryStreamIsJudged) {
  const Demonstration markers = recorded_reach();
  const std::size_t rows = positions(markers).rows;
  Demonstration recording;
  recording.streams.sensors.emplace();
  BodyStream& sensors = *recording.streams.sensors;
  sensors.names = {"shoulder", "elbow", "wrist"};
  sensors.time = markers.streams.markers->time;
  sensors.position = Array2D<Vec3>(rows, 3, unknown_point());
  sensors.orientation = Array2D<Quat>(rows, 3, Quat::Identity());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      sensors.position(i, k) = positions(markers)(i, column(markers, k == 0   ? "RSHO1"
                                                                     : k == 1 ? "RUAR1"
                                                                              : "RHAN1"));
  }
  sensors.position(kInReach, 2) += Vec3(0.1, 0, 0);
  const RecordingFlag flag = only_flag(recording);
  EXPECT_EQ(flag.code, FlagCode::spike);
  EXPECT_EQ(flag.subject, "wrist");
  EXPECT_FALSE(is_known(sensors.position(kInReach, 2)));
  EXPECT_FALSE(is_known(sensors.orientation(kInReach, 2)));
}

}  // namespace
}  // namespace morphe::imports
