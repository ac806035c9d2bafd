#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Conventions kTrc{"x y z", "", {}};

/// Two markers in two frames; `from` becomes `to` in it, commas the separator.
std::string trc(const std::string& from = "", const std::string& to = "", char separator = '\t') {
  std::string text =
      "PathFileType,4,(X/Y/Z),/home/somebody/subject.trc\n"
      "DataRate,CameraRate,NumFrames,NumMarkers,Units,OrigDataRate,OrigDataStartFrame,"
      "OrigNumFrames\n"
      "100,100,2,2,mm,100,1,2\n"
      "Frame#,Time,A,,,B,,\n"
      ",,X1,Y1,Z1,X2,Y2,Z2\n"
      "\n"
      "1,0.00,10,20,30,40,50,60\n"
      "2,0.01,11,21,31,41,51,61\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  std::ranges::replace(text, ',', separator);
  return text;
}

class Trc : public RecordingFolder {
 protected:
  std::filesystem::path write(const std::string& text) {
    return RecordingFolder::write(text, "trial.trc");
  }
  std::string error_of(const std::string& from, const std::string& to) {
    return RecordingFolder::error_of(write(trc(from, to)), kTrc);
  }
  std::vector<std::string> reports_of(const std::string& from, const std::string& to) {
    return read(write(trc(from, to)), kTrc).import_notes;
  }
};

TEST_F(Trc, TabsAndCommasReadTheSame) {
  for (const char separator : {'\t', ','}) {
    const Demonstration d = read(write(trc("", "", separator)), kTrc);
    const MarkerStream& markers = *d.streams.markers;
    EXPECT_THAT(markers.names, ElementsAre("A", "B"));
    EXPECT_THAT(markers.time, ElementsAre(0, 0.01));
    EXPECT_LT((markers.position(1, 1) - Vec3(0.041, 0.051, 0.061)).norm(), 1e-15);
    EXPECT_THAT(d.import_notes, ElementsAre());
  }
}

TEST_F(Trc, ThePathInTheFileIsNotKept) {
  const Demonstration d = read(write(trc()), kTrc);
  EXPECT_EQ(d.source, "");
  EXPECT_EQ(d.subject, "");
  EXPECT_EQ(d.task, "");
}

TEST_F(Trc, AxesAreAskedForAndUsed) {
  EXPECT_EQ(RecordingFolder::error_of(write(trc())),
            "trial.trc: axes: the file does not state which axes point right, forward and up; give "
            "--axes or `axes:` such as 'x y z'");
  const Demonstration d = read(write(trc()), {"y -x z", "", {}});
  EXPECT_LT((d.streams.markers->position(0, 0) - Vec3(0.02, -0.01, 0.03)).norm(), 1e-15);
}

TEST_F(Trc, WhatTheHeaderPromisesIsCompared) {
  EXPECT_THAT(reports_of("100,100,2,2", "100,100,652,51"),
              ElementsAre("the header states 51 markers, the file has 2",
                          "the header states 652 frames, the file has 2"));
  EXPECT_THAT(reports_of("100,100,2", "60,100,2"),
              ElementsAre("the header states 60 frames per second, the times give 100; the times "
                          "are used"));
  EXPECT_THAT(reports_of("\n\n", "\n"), ElementsAre());  // no blank line before the frames
}

TEST_F(Trc, EmptyNanAndOriginWereNotSeen) {
  for (const char* cells : {",,", "NaN,nan,NAN"}) {
    const Demonstration d = read(write(trc("10,20,30", cells)), kTrc);
    EXPECT_FALSE(is_known(d.streams.markers->position(0, 0)));
    EXPECT_TRUE(is_known(d.streams.markers->position(1, 0)));
  }
  const Demonstration d = read(write(trc("10,20,30", "0,0.000,0")), kTrc);
  EXPECT_FALSE(is_known(d.streams.markers->position(0, 0)));
  EXPECT_THAT(d.import_notes,
              ElementsAre("1 points are exactly at the origin; treated as not visible"));
}

TEST_F(Trc, ErrorsSayWhere) {
  EXPECT_EQ(error_of("10,20,30", "10,2x,30"), "trial.trc:7: A.Y: must be a number, not '2x'");
  EXPECT_EQ(error_of(",51,61", ",51"), "trial.trc:8: B.Z: the row has 7 cells, the header has 8");
  EXPECT_EQ(error_of(",51,61", ",51,61,7"),
            "trial.trc:8: column 9: the row has 9 cells, the header has 8");
  EXPECT_EQ(error_of("2,0.01", "2,-0.01"),
            "trial.trc:8: Time: must be greater than in the previous row");
  EXPECT_EQ(error_of("2,0.01", "2,"), "trial.trc:8: Time: must be a number, not ''");
  EXPECT_EQ(error_of("Y2", "Z2"), "trial.trc:5: B.Y: must be under 'Y2'");
  EXPECT_THAT(error_of("mm", "ell"), HasSubstr("trial.trc:3: unit: 'ell' in the file is unknown"));
  EXPECT_THAT(error_of("mm", ""), HasSubstr("trial.trc:3: unit: not in the file"));
  EXPECT_EQ(error_of("Frame#", "Row"), "trial.trc:4: must begin with 'Frame#' and 'Time'");
  EXPECT_EQ(error_of("NumFrames", "Units"), "trial.trc:2: Units: appears twice");
  const std::string text = trc();
  EXPECT_EQ(RecordingFolder::error_of(write(text.substr(0, text.find("\n1\t"))), kTrc),
            "trial.trc:5: ends before the first frame");
}

/// As OpenSim, Motion Analysis, Cortex and scripts write the header.
TEST_F(Trc, HeadersOfManyPrograms) {
  std::string adjacent = trc("A,,,B,,", "A,B");
  const std::string blanks = [] {
    std::string text = trc("A,,,B,,", "A,B", ' ');
    return text.replace(text.find("  X1"), 2, "");
  }();
  for (const std::string& text :
       {trc("X1,Y1,Z1,X2,Y2,Z2", "X,Y,Z,X,Y,Z"), trc("X1,Y1,Z1,X2,Y2,Z2", "x1,y1,z1,x2,y2,z2"),
        trc(",,X1,Y1,Z1,X2,Y2,Z2\n\n", ""), trc("\n\n", "\n\n\n\n"), trc("A,,,B,,", "A,,,B"),
        trc("A,,,B,,", "A,A,A,B,B,B"), trc("A,,,B,,", "A_X,A_Y,A_Z,B_X,B_Y,B_Z"),
        trc("Frame#,Time", "Frame,time"), trc("mm", "Millimetres"), trc("mm", "MM"), adjacent,
        blanks}) {
    const Demonstration d = read(write(text), kTrc);
    const MarkerStream& markers = *d.streams.markers;
    EXPECT_THAT(markers.names, ElementsAre("A", "B")) << text;
    ASSERT_EQ(markers.time.size(), 2u) << text;
    EXPECT_LT((markers.position(1, 1) - Vec3(0.041, 0.051, 0.061)).norm(), 1e-15) << text;
    EXPECT_THAT(d.import_notes, ElementsAre()) << text;
  }
}

TEST_F(Trc, EditorsRemoveTabsAtTheEndOfALine) {
  const Demonstration d = read(write(trc(",40,50,60", "")), kTrc);
  EXPECT_TRUE(is_known(d.streams.markers->position(0, 0)));
  EXPECT_FALSE(is_known(d.streams.markers->position(0, 1)));
}

TEST_F(Trc, AGivenRateReplacesTheTimes) {
  const Demonstration d = read(write(trc("2,0.01", "2,0.00")), {"x y z", "", 50.0});
  EXPECT_THAT(d.streams.markers->time, ElementsAre(0, 0.02));
}

/// Numbers that Python read from the text.
TEST_F(Trc, ShippedFileMatchesItsText) {
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/pyomeca/recordings.yaml"};
  std::vector<Demonstration> all;
  import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  ASSERT_EQ(all.size(), 3u);
  const MarkerStream& markers = *all[1].streams.markers;
  ASSERT_EQ(markers.names.size(), 51u);
  ASSERT_EQ(markers.time.size(), 93u);
  EXPECT_DOUBLE_EQ(markers.time.back(), 0.92);
  EXPECT_EQ(markers.names[15], "RGTH");
  EXPECT_LT((markers.position(0, 0) - Vec3(0.0809832, -0.7337041, 0.1918668)).norm(), 1e-12);
  EXPECT_LT((markers.position(92, 50) - Vec3(-0.0760879, -0.3467847, 0.2298264)).norm(), 1e-12);
  for (const Vec3& point : markers.position.values) EXPECT_TRUE(is_known(point));
  EXPECT_THAT(all[1].import_notes,
              testing::Contains("the header states 652 frames, the file has 93"));
}

}  // namespace
}  // namespace morphe::imports
