#include <gmock/gmock.h>

#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/format.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const Conventions kMetres{"x y z", "m", 100.0}, kUpright{"x y z", "", {}};

class PointCsv : public RecordingFolder {
 protected:
  /// Points A at 1, 2, 3 and B at 4, 5, 6 in the first row, in whatever way it was written.
  void expect_points(const std::string& text, const Conventions& conventions, double metres = 1) {
    SCOPED_TRACE(text);
    const MarkerStream markers = *read(write(text), conventions).streams.markers;
    ASSERT_THAT(markers.names, ElementsAre("A", "B"));
    EXPECT_LT((markers.position(0, 0) - metres * Vec3(1, 2, 3)).norm(), 1e-12);
    EXPECT_LT((markers.position(0, 1) - metres * Vec3(4, 5, 6)).norm(), 1e-12);
  }
};

TEST_F(PointCsv, TheAxisStandsBehindBeforeOrGrownToTheName) {
  for (const char* header :
       {"A_x,A_y,A_z,B_x,B_y,B_z", "A.X,A.Y,A.Z,B.X,B.Y,B.Z", "A X,A Y,A Z,B X,B Y,B Z",
        "A:X,A:Y,A:Z,B:X,B:Y,B:Z", "x_A,y_A,z_A,x_B,y_B,z_B", "AX,AY,AZ,BX,BY,BZ",
        "\"A_x\",\"A_y\",\"A_z\",\"B_x\",\"B_y\",\"B_z\""}) {
    expect_points(std::string(header) + "\n1,2,3,4,5,6\n1,2,3,4,5,6\n", kMetres);
  }
}

TEST_F(PointCsv, SemicolonsTabsAndDecimalCommas) {
  expect_points("A_x;A_y;A_z;B_x;B_y;B_z\n1,0;2,0;3,0;4,0;5,0;6,0\n", kMetres);
  expect_points("A_x\tA_y\tA_z\tB_x\tB_y\tB_z\n1.0\t2.0\t3.0\t4.0\t5.0\t6.0\n", kMetres);
  const Demonstration d = read(write("A_x;A_y;A_z\n0,125;1;2\n"), kMetres);
  EXPECT_DOUBLE_EQ(d.streams.markers->position(0, 0).x(), 0.125);
  EXPECT_THAT(d.import_notes, Contains("numbers use decimal commas"));
}

TEST_F(PointCsv, UnitsInTheHeader) {
  const Conventions rate{"x y z", "", 100.0};
  expect_points("A_x (mm),A_y (mm),A_z (mm),B_x (mm),B_y (mm),B_z (mm)\n1,2,3,4,5,6\n", rate, 1e-3);
  expect_points("A_x[cm],A_y[cm],A_z[cm],B_x[cm],B_y[cm],B_z[cm]\n1,2,3,4,5,6\n", rate, 1e-2);
  expect_points("A_x_m,A_y_m,A_z_m,B_x_m,B_y_m,B_z_m\n1,2,3,4,5,6\n", rate);
  expect_points("A,,,B,,\nX,Y,Z,X,Y,Z\nmm,mm,mm,mm,mm,mm\n1,2,3,4,5,6\n", rate, 1e-3);
  EXPECT_THAT(error_of(write("A_x (mm),A_y (mm),A_z (cm)\n1,2,3\n"), rate),
              HasSubstr("trial.csv:1: A: has the unit 'cm', but the first point has 'mm'"));
}

TEST_F(PointCsv, TwoLinesOfHeaderBehindLinesOfTheirOwn) {
  const Demonstration d = read(write("Subject: 07\nDate,2024\n\nframe,time,A,,,B,,\n"
                                     ",s,X,Y,Z,X,Y,Z\n1,0.00,1,2,3,4,5,6\n2,0.01,1,2,3,,,\n"),
                               {"x y z", "m", {}});
  EXPECT_THAT(d.streams.markers->names, ElementsAre("A", "B"));
  EXPECT_THAT(d.streams.markers->time, ElementsAre(0, 0.01));
  EXPECT_FALSE(is_known(d.streams.markers->position(1, 1)));
}

TEST_F(PointCsv, TimesInTheirUnitOrSaidToBeTaken) {
  const auto times = [&](const std::string& header, const std::string& first,
                         const std::string& second) {
    return read(write(header + ",A_x,A_y,A_z\n" + first + ",1,2,3\n" + second + ",1,2,3\n"),
                {"x y z", "m", {}});
  };
  EXPECT_NEAR(times("time_ms", "0", "10").streams.markers->time[1], 0.01, 1e-15);
  EXPECT_NEAR(times("timestamp_us", "0", "8000").streams.markers->time[1], 0.008, 1e-15);
  const Demonstration unsaid = times("t", "100", "108");
  EXPECT_NEAR(unsaid.streams.markers->time[1] - unsaid.streams.markers->time[0], 0.008, 1e-12);
  EXPECT_THAT(unsaid.import_notes,
              Contains("unit of 't' not in the file; assumed ms, 125 rows per second"));
  const Demonstration clock = times("time", "1700000000.00", "1700000000.01");
  EXPECT_EQ(clock.streams.markers->time[0], 0);
  EXPECT_THAT(clock.import_notes, Contains("times are counted from that of the first row"));
}

TEST_F(PointCsv, FramesHaveTheGivenRateAndMayLeaveOut) {
  const Demonstration d =
      read(write("frame,A_x,A_y,A_z\n10,1,2,3\n11,1,2,3\n14,1,2,3\n"), {"x y z", "m", 50.0});
  EXPECT_THAT(d.streams.markers->time, ElementsAre(0, 0.02, 0.08));
}

TEST_F(PointCsv, WhatIsNoPointIsLeftOutAndSaid) {
  const Demonstration d =
      read(write("t_s,A_x,A_y,A_z,A_qx,A_qy,A_qz,A_qw,A_vel_x,A_vel_y,A_vel_z,force\n"
                 "0.00,1,2,3,0,0,0,1,7,7,7,5\n0.01,1,2,3,0,0,0,1,7,7,7,5\n"),
           {"x y z", "m", {}});
  EXPECT_THAT(d.streams.markers->names, ElementsAre("A"));
  EXPECT_THAT(d.import_notes, Contains("columns skipped, not points: A_vel, A_q, force"));
}

TEST_F(PointCsv, WhatWasNotSeen) {
  for (const char* cells : {",,", "NaN,nan,NAN", "NA,NA,NA", "null,null,null", "-,-,-"}) {
    const Demonstration d = read(
        write(std::string("A_x,A_y,A_z,B_x,B_y,B_z\n") + cells + ",4,5,6\n1,2,3,4,5,6\n"), kMetres);
    EXPECT_FALSE(is_known(d.streams.markers->position(0, 0))) << cells;
    EXPECT_TRUE(is_known(d.streams.markers->position(0, 1))) << cells;
  }
}

TEST_F(PointCsv, JointNamesMakeASkeletonAndTheRestStaysMarkers) {
  const Demonstration d = read(write("right_shoulder_x,right_shoulder_y,right_shoulder_z,"
                                     "right_elbow_x,right_elbow_y,right_elbow_z,"
                                     "right_wrist_x,right_wrist_y,right_wrist_z,cup_x,cup_y,cup_z\n"
                                     "0,0,1,0,0,0.7,0,0.2,0.7,0,0.5,0.7\n"
                                     "0,0,1,0,0,0.7,0,0.2,0.7,0,0.5,0.7\n"),
                               kMetres);
  ASSERT_TRUE(d.streams.skeleton && d.streams.markers);
  EXPECT_THAT(d.streams.skeleton->names,
              ElementsAre("right_shoulder", "right_elbow", "right_wrist"));
  EXPECT_LT((d.streams.skeleton->position(1, 2) - Vec3(0, 0.2, 0.7)).norm(), 1e-15);
  EXPECT_FALSE(is_known(d.streams.skeleton->orientation(0, 0)));
  EXPECT_THAT(d.streams.markers->names, ElementsAre("cup"));
}

TEST_F(PointCsv, EveryDamageHasItsLineAndColumn) {
  const std::string head = "time_s,A_x,A_y,A_z\n";
  const Conventions metres{"x y z", "m", {}};
  const auto error = [&](const std::string& rows) { return error_of(write(head + rows), metres); };
  EXPECT_EQ(error("0,1,2,3\n0.01,1,2\n0.02,1,2,3\n"),
            "trial.csv:3: the row has 3 cells, but the header has 4");
  EXPECT_EQ(error("0,1,2,3\n0.01,1,two,3\n"), "trial.csv:3: A.y: must be a number, not 'two'");
  EXPECT_EQ(error("0.01,1,2,3\n0.00,1,2,3\n"),
            "trial.csv:3: time: must be greater than in the previous row");
  EXPECT_THAT(error(""), HasSubstr("trial.csv"));
  EXPECT_THAT(error_of(write("A_x;A_y;A_z\n1.5;2,5;3,5\n1,5;2,5;3,5\n"), kMetres),
              HasSubstr("trial.csv:2: A.x: must be a number, not '1.5'"));
  EXPECT_THAT(error_of(write("a,b,c\n1,2,3\n"), kMetres), HasSubstr("format: not recognised"));
  EXPECT_THAT(error_of(write(head + "0,1,2,3\n0.01,1,2,3\n"), kUpright), HasSubstr(": unit: "));
  EXPECT_THAT(error_of(write("A_x,A_y,A_z\n1,2,3\n1,2,3\n"), {"x y z", "m", {}}),
              HasSubstr(": rate: "));
}

TEST_F(PointCsv, AnglesOfWhichThreeLookLikeAPointAreNoRecording) {
  EXPECT_FALSE(
      recognises_point_csv("Finger Velocity,Scap_X,Scap_Y,Scap_Z,abduction,flexion,rotation,"
                           "elbow,pronation\n0.8,-14.5,-23.4,10.9,-28.7,-38.3,-25.9,79,-18\n"));
  EXPECT_TRUE(
      recognises_point_csv("time,wrist_x,wrist_y,wrist_z,wrist_qx,wrist_qy,wrist_qz,wrist_qw\n"
                           "0,1,2,3,0,0,0,1\n"));
}

}  // namespace
}  // namespace morphe::imports
