#include "core/motion/stream_report.hpp"

#include <gmock/gmock.h>

namespace morphe {
namespace {

using ::testing::ElementsAre;

/// Markers a, b, c at 10 Hz for a second: a hidden in samples 2–4 and in the last, c never seen.
Streams three_markers() {
  MarkerStream markers;
  markers.names = {"a", "b", "c"};
  markers.position = Array2D<Vec3>(11, 3, Vec3(1, 2, 3));
  for (std::size_t i = 0; i < 11; ++i) {
    markers.time.push_back(0.5 + 0.1 * static_cast<double>(i));
    markers.position(i, 2) = unknown_point();
    if ((i >= 2 && i <= 4) || i == 10) markers.position(i, 0) = unknown_point();
  }
  Streams streams;
  streams.markers = std::move(markers);
  return streams;
}

TEST(StreamReport, CountsWhatIsThereAndWhatIsNot) {
  const std::vector<StreamReport> reports = report_streams(three_markers());
  ASSERT_EQ(reports.size(), 1u);
  const StreamReport& report = reports.front();
  EXPECT_EQ(report.name, "markers");
  EXPECT_EQ(report.columns, 3u);
  EXPECT_DOUBLE_EQ(report.begin_s, 0.5);
  EXPECT_NEAR(report.duration_s, 1, 1e-12);
  EXPECT_NEAR(report.rate_hz, 10, 1e-9);
  EXPECT_NEAR(report.valid_share, (7 + 11) / 33.0, 1e-12);
  EXPECT_EQ(report.gaps, 3u);
  EXPECT_THAT(report.empty_columns, ElementsAre("c"));
  EXPECT_EQ(report.longest_gap_column, "c");
  EXPECT_NEAR(report.longest_gap_s, 1.1, 1e-9);
}

TEST(StreamReport, TheLongestStreamSaysHowLongARecordingIs) {
  Streams streams = three_markers();
  streams.hand.emplace();
  streams.hand->kind = HandKind::glove;
  streams.hand->names = {"sensor"};
  streams.hand->time = {0, 2};
  streams.hand->angles = JointRows::Zero(2, 1);
  EXPECT_NEAR(longest_duration_s(report_streams(streams)), 2, 1e-12);
  EXPECT_EQ(longest_duration_s({}), 0);
}

}  // namespace
}  // namespace morphe
