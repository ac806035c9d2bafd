#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using KeypointsCsv = RecordingFolder;

std::string header(const std::string& first) {
  std::string text = first;
  for (int k = 0; k < 21; ++k) text += fmt::format(",kp{0:02}_x,kp{0:02}_y,kp{0:02}_z", k);
  return text + "\n";
}
/// The wrist at the origin, point k at (k, 2 k, 5 k).
std::string row(const std::string& first, const std::string& kp20 = "20,40,100") {
  std::string text = first;
  for (int k = 0; k < 20; ++k) text += fmt::format(",{},{},{}", k, 2 * k, 5 * k);
  return text + "," + kp20 + "\n";
}
const Conventions kKeypoints{"", "mm", 20.0};

TEST_F(KeypointsCsv, ReadsFramesWithARateOrTimes) {
  const Demonstration d =
      read(write(header("frame") + row("3") + row("5", "nan,NaN,") + row("6", ",,")), kKeypoints);
  const HandStream& hand = *d.streams.hand;
  EXPECT_EQ(hand.kind, HandKind::keypoints);
  EXPECT_THAT(hand.time, ElementsAre(3 / 20.0, 5 / 20.0, 6 / 20.0));
  ASSERT_EQ(hand.position.cols, 21u);
  EXPECT_LT((hand.position(0, 7) - Vec3(0.007, 0.014, 0.035)).norm(), 1e-15);
  EXPECT_LT((hand.position(0, 20) - Vec3(0.020, 0.040, 0.100)).norm(), 1e-15);
  EXPECT_FALSE(is_known(hand.position(1, 20)));
  EXPECT_FALSE(is_known(hand.position(2, 20)));
  EXPECT_THAT(d.import_notes, ElementsAre("2 of 63 points are not visible",
                                          HasSubstr("the wrist is the origin in every frame")));
  const Demonstration timed =
      read(write(header("time_s") + row("0.25") + row("0.5")), {"", "mm", std::nullopt});
  EXPECT_THAT(timed.streams.hand->time, ElementsAre(0.25, 0.5));
}

TEST_F(KeypointsCsv, BrokenFilesAreNamedWithTheirLine) {
  const std::string head = header("frame");
  const auto error = [&](const std::string& text, const Conventions& given = kKeypoints) {
    return error_of(write(text, "k.csv"), given);
  };
  EXPECT_EQ(error(head + row("0") + row("1")), "no error");
  EXPECT_THAT(error(head + row("0"), {"", "", 20.0}), HasSubstr("k.csv: unit: "));
  EXPECT_THAT(error(head + row("0"), {"", "mm", std::nullopt}), HasSubstr("k.csv: rate"));
  EXPECT_THAT(error(head + row("0"), {"", "m", 20.0}),
              HasSubstr("k.csv:1: unit: implausible: a point would be 110 m from the wrist"));
  EXPECT_EQ(error(head), "k.csv:1: the file ends before the first row");
  EXPECT_EQ(error(head + row("1") + row("0")),
            "k.csv:3: frame: must be greater than in the previous row");
  EXPECT_EQ(error(head + row("0.5")), "k.csv:2: frame: must be a whole number, at least 0");
  EXPECT_EQ(error(head + row("0", "1,2")), "k.csv:2: the row has 63 cells, the header has 64");
  EXPECT_EQ(error(head + row("0", "1,2,z")), "k.csv:2: kp20_z: must be a number, not 'z'");
  EXPECT_EQ(error(header("Frame") + row("0")),
            "k.csv:1: frame: column not found; frame or time_s is required");
  std::string twice = head;
  twice.replace(twice.find("kp07_y"), 6, "kp07_x");
  EXPECT_EQ(error(twice + row("0")), "k.csv:1: kp07_x: the column appears twice");
  std::string missing = head;
  missing.replace(missing.find("kp07_y"), 6, "kp07_w");
  EXPECT_EQ(error(missing + row("0")), "k.csv:1: kp07_y: the column is missing");
  EXPECT_EQ(error(header("frame,extra") + row("0,1")), "k.csv:1: extra: unknown column");
  std::string unseen = "0";
  for (int k = 0; k < 63; ++k) unseen += ",";
  EXPECT_THAT(read(write(head + unseen + "\n", "k.csv"), kKeypoints).import_notes,
              testing::Contains("no point is visible in any frame"));
}

// The shipped recording; the numbers by Python with numpy.
TEST_F(KeypointsCsv, ReadsTheShippedOne) {
  ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) /
                   "datasets/dex-retargeting/recordings.yaml"};
  const Demonstration d = read(request);
  const HandStream& hand = *d.streams.hand;
  ASSERT_EQ(hand.time.size(), 621u);
  EXPECT_NEAR(hand.time.back(), 620 / 30.0, 1e-12);
  EXPECT_LT((hand.position(0, 4) - Vec3(-0.016241, 0.095697, 0.086553)).norm(), 1e-12);
  EXPECT_LT((hand.position(1, 20) - Vec3(0.043775, -0.058397, 0.118464)).norm(), 1e-12);
  double least = 1, most = 0, palm_least = 1, palm_most = 0;
  for (std::size_t i = 0; i < 621; ++i) {
    const double pinch = (hand.position(i, 4) - hand.position(i, 8)).norm();
    least = std::min(least, pinch);
    most = std::max(most, pinch);
    palm_least = std::min(palm_least, hand.position(i, 9).norm());
    palm_most = std::max(palm_most, hand.position(i, 9).norm());
  }
  EXPECT_NEAR(least, 0.015035, 1e-6);
  EXPECT_NEAR(most, 0.148166, 1e-6);
  EXPECT_NEAR(palm_least, 0.0808, 1e-4);
  EXPECT_NEAR(palm_most, 0.1113, 1e-4);
  EXPECT_THAT(d.import_notes, ElementsAre(HasSubstr("the wrist is the origin in every frame")));
}

}  // namespace
}  // namespace morphe::imports
