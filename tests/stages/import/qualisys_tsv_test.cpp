#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const Conventions kUp{"x y z", "", {}};

/// Two markers in two frames, B hidden in the second.
std::string tsv(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "NO_OF_FRAMES\t2\nNO_OF_CAMERAS\t8\nNO_OF_MARKERS\t2\nFREQUENCY\t200\nNO_OF_ANALOG\t0\n"
      "DESCRIPTION\t--\nTIME_STAMP\t2024-03-01, 10:12:30.123\t77.5\nDATA_INCLUDED\t3D\n"
      "EVENT\tgrasp\t1\t0.005\nEVENT\tlift\t2\t0.010\nMARKER_NAMES\tA\tB\n"
      "1\t0.00000\t10.0\t20.0\t30.0\t40.0\t50.0\t60.0\n"
      "2\t0.00500\t11.0\t21.0\t31.0\t0.000\t0.000\t0.000\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

class QualisysTsv : public RecordingFolder {
 protected:
  Demonstration read_text(const std::string& text) { return read(write(text, "q.tsv"), kUp); }
  std::string error(const std::string& from, const std::string& to) {
    return error_of(write(tsv(from, to), "q.tsv"), kUp);
  }
};

void expect_two_markers(const Demonstration& d) {
  const MarkerStream& markers = *d.streams.markers;
  EXPECT_THAT(markers.names, ElementsAre("A", "B"));
  EXPECT_THAT(markers.time, ElementsAre(0, 0.005));
  EXPECT_LT((markers.position(1, 0) - Vec3(0.011, 0.021, 0.031)).norm(), 1e-15);
  EXPECT_LT((markers.position(0, 1) - Vec3(0.04, 0.05, 0.06)).norm(), 1e-15);
  EXPECT_FALSE(is_known(markers.position(1, 1)));
}

TEST_F(QualisysTsv, ReadsMillimetresAndTheOriginIsNotSeen) {
  const Demonstration d = read_text(tsv());
  expect_two_markers(d);
  EXPECT_THAT(d.import_notes, Contains("unit not in the file; assumed mm, as written by Qualisys"));
}

TEST_F(QualisysTsv, WithColumnNamesAndWithoutFrameAndTime) {
  expect_two_markers(
      read_text(tsv("1\t0.00000", "Frame\tTime\tA X\tA Y\tA Z\tB X\tB Y\tB Z\n1\t0.00000")));
  std::string bare = tsv("1\t0.00000\t", "");
  bare.replace(bare.find("2\t0.00500\t"), 10, "");
  expect_two_markers(read_text(bare));
}

TEST_F(QualisysTsv, AFrameThatIsLeftOutIsAGapInTime) {
  EXPECT_THAT(read_text(tsv("2\t0.00500", "4\t0.01500")).streams.markers->time,
              ElementsAre(0, 0.015));
}

TEST_F(QualisysTsv, EveryDamageHasItsLine) {
  EXPECT_THAT(error("MARKER_NAMES\tA\tB", "MARKER_NAMES\tA"), HasSubstr("q.tsv:12: the row has"));
  EXPECT_THAT(error("21.0", "x"), HasSubstr("q.tsv:13: A: must be a number, not 'x'"));
  EXPECT_THAT(error("\t0.000\t0.000\t0.000", ""), HasSubstr("q.tsv:13: B: the row has 5 cells"));
  EXPECT_THAT(error("2\t0.00500", "0\t0.00500"), HasSubstr("q.tsv:13: Frame: must be greater"));
  EXPECT_THAT(error("DATA_INCLUDED\t3D", "DATA_INCLUDED\t6D"), HasSubstr("must be 3D, not '6D'"));
  EXPECT_THAT(error("FREQUENCY\t200", "FREQUENCY\t"), HasSubstr("rate: not in the file"));
  const std::string whole = tsv();
  EXPECT_THAT(error(whole.substr(whole.find("1\t0.00000")), ""),
              HasSubstr("before the first frame"));
}

}  // namespace
}  // namespace morphe::imports
