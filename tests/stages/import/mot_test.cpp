#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Mot = RecordingFolder;

const std::string kHead =
    "Coordinates\nversion=1\nnRows=2\nnColumns=3\ninDegrees=yes\n\nendheader\n";

TEST_F(Mot, ReadsDegreesOrRadiansSeparatedInAnyWay) {
  for (const char* table : {"time,elbow,wrist\n0.5,90,-180\n0.75,1e1,+20\n",
                            "time\telbow\twrist\n0.5\t90\t-180\n0.75\t1e1\t+20\n",
                            "  time   elbow wrist  \r\n 0.5 90    -180\r\n\r\n0.75 1e1 +20\r\n",
                            "time,elbow,wrist,,\n0.5,90,-180,,,\n,,,\n0.75,1e1,+20\n"}) {
    const Demonstration d = read(write(kHead + table, "a.mot"));
    const AngleStream& angles = *d.streams.arm_angles;
    EXPECT_THAT(angles.joints, ElementsAre("elbow", "wrist"));
    EXPECT_THAT(angles.time, ElementsAre(0.5, 0.75));
    EXPECT_NEAR(angles.angles(0, 0), M_PI / 2, 1e-15);
    EXPECT_NEAR(angles.angles(0, 1), -M_PI, 1e-15);
    EXPECT_NEAR(angles.angles(1, 0), M_PI / 18, 1e-15);
    EXPECT_NEAR(angles.angles(1, 1), M_PI / 9, 1e-15);
  }
  const Demonstration d =
      read(write("DataType=double\ninDegrees = NO\nENDHEADER\ntime q\n0 1.5\n", "a.sto"));
  EXPECT_EQ(d.streams.arm_angles->angles(0, 0), 1.5);
  EXPECT_TRUE(d.import_notes.empty());
}

TEST_F(Mot, ReportsWhatItLeavesOutAndWhereTheHeaderIsWrong) {
  const std::string table =
      "time,pelvis_tx,elbow,box_transX,wrist\n0,1,30,2,nan\n1,1,30,2,40\n2,1,30,2,40\n";
  const Demonstration d = read(write(kHead + table, "a.mot"));
  EXPECT_THAT(d.streams.arm_angles->joints, ElementsAre("elbow", "wrist"));
  EXPECT_TRUE(std::isnan(d.streams.arm_angles->angles(0, 1)));
  EXPECT_THAT(d.import_notes, ElementsAre("nRows is 2, but the file has 3 rows; all are used",
                                          "nColumns is 3, but the file has 5 columns; all are used",
                                          "translations skipped: pelvis_tx, "
                                          "box_transX",
                                          "1 of 6 angles are missing (NaN)"));
}

TEST_F(Mot, BrokenFilesAreNamedWithTheirLine) {
  const auto error = [&](const std::string& text, const Conventions& given = {}) {
    ImportRequest request;
    request.paths = {write(text, "a.mot")};
    request.format = "mot";
    request.conventions = given;
    try {
      read(request);
    } catch (const InputError& e) {
      return std::string(e.what()).substr(folder_.string().size() + 1);
    }
    return std::string("no error");
  };
  EXPECT_EQ(error(""), "a.mot:1: endheader: the line is missing");
  EXPECT_EQ(error("nRows=1\ntime a\n0 1\n"), "a.mot:3: endheader: the line is missing");
  EXPECT_EQ(error(kHead), "a.mot:7: the file ends after its header");
  EXPECT_EQ(error(kHead + "time,a\n"), "a.mot:8: the file has no rows");
  EXPECT_EQ(error(kHead + "t,a\n0,1\n"), "a.mot:8: time: the first column must have this name");
  EXPECT_EQ(error(kHead + "time,,a\n0,1,2\n"), "a.mot:8: column 2 has no name");
  EXPECT_EQ(error(kHead + "time,a_tx\n0,1\n"),
            "a.mot:8: has no column of a joint angle, only translations");
  EXPECT_EQ(error(kHead + "time,a,b\n0,1\n"), "a.mot:9: b: the row has 2 cells, the header has 3");
  EXPECT_EQ(error(kHead + "time,a\n0,1,2\n"), "a.mot:9: the row has 3 cells, the header has 2");
  EXPECT_EQ(error(kHead + "time,a\n0,x\n"), "a.mot:9: a: must be a number, not 'x'");
  EXPECT_EQ(error(kHead + "time,a\nnan,1\n"), "a.mot:9: time: must be a number, not 'nan'");
  EXPECT_EQ(error(kHead + "time,a\n1,1\n0,1\n"),
            "a.mot:10: time: must be greater than in the previous row");
  EXPECT_EQ(error("inDegrees=maybe\nendheader\ntime,a\n0,1\n"),
            "a.mot:2: inDegrees: must be yes or no, not 'maybe'");
  EXPECT_THAT(error("endheader\ntime,a\n0,1\n"), HasSubstr("give --unit or `unit:` deg or rad"));
  EXPECT_EQ(error("endheader\ntime,a\n0,1\n", {"", "deg", std::nullopt}), "no error");
  EXPECT_EQ(error("nRows=x\ninDegrees=no\nendheader\ntime,a\n0,1\n"),
            "a.mot:3: nRows: must be a number, not 'x'");
}

TEST_F(Mot, ColumnsOfOtherQuantitiesAreNoAngles) {
  const Demonstration d = read(write(
      kHead + "time,/jointset/elbow/elbow_flexion/value,/jointset/elbow/elbow_flexion/speed,"
              "/forceset/BIClong/activation,BIClong.fiber_length,elbow_flexion_moment,wrist_rotY,"
              "ground_force_vx,1_ground_torque_y,ground_force_px\n0,90,1,2,3,4,45,5,6,7\n",
      "a.sto"));
  EXPECT_THAT(d.streams.arm_angles->joints, ElementsAre("elbow_flexion", "wrist_rotY"));
  EXPECT_NEAR(d.streams.arm_angles->angles(0, 1), M_PI / 4, 1e-15);
  EXPECT_THAT(d.import_notes,
              testing::IsSupersetOf(
                  {"muscle states skipped: /forceset/BIClong/activation, BIClong.fiber_length",
                   "speeds skipped: /jointset/elbow/elbow_flexion/speed",
                   "forces and moments skipped: elbow_flexion_moment, ground_force_vx, "
                   "1_ground_torque_y, ground_force_px"}));
}

TEST_F(Mot, FilesWithoutJointAnglesAreRefused) {
  EXPECT_EQ(error_of(write(kHead + "time,ground_force_vx,ground_force_px\n0,1,2\n", "a.mot")),
            "a.mot:8: has no column of a joint angle, only forces and moments");
  for (const auto& [title, contents] :
       {std::pair("Static Optimization", "muscle forces or activations"),
        std::pair("Inverse Dynamics Generalized Forces", "forces and moments"),
        std::pair("ModelControls", "muscle excitations"), std::pair("Speeds", "speeds")}) {
    std::string text = kHead + "time,DELT1\n0,0.5\n";
    text.replace(0, text.find('\n'), title);
    EXPECT_EQ(error_of(write(text, "a.sto")),
              fmt::format("a.sto:1: has {}, no joint angles", contents));
  }
}

// The shipped trial; the numbers by Python's csv and math.radians.
TEST_F(Mot, ReadsTheShippedOne) {
  const Demonstration d =
      read(std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/pyomeca/inverse_kin.mot");
  const AngleStream& angles = *d.streams.arm_angles;
  ASSERT_EQ(angles.joints.size(), 19u);
  ASSERT_EQ(angles.time.size(), 88u);
  EXPECT_EQ(angles.time.front(), 1.56);
  EXPECT_EQ(angles.time.back(), 2.43);
  EXPECT_EQ(angles.joints[12], "elbow_flexion");
  EXPECT_NEAR(angles.angles(0, 12), 0.734195168, 1e-9);
  EXPECT_NEAR(angles.angles(43, 12), 1.496887885, 1e-9);
  EXPECT_NEAR(angles.angles(87, 12), 2.228418745, 1e-9);
  EXPECT_EQ(angles.joints[17], "box_rotY");
  EXPECT_NEAR(angles.angles(0, 17), -3.159095987, 1e-9);
  EXPECT_THAT(d.import_notes,
              ElementsAre("nRows is 250, but the file has 88 rows; all are used",
                          HasSubstr("thorax_tx, thorax_ty, thorax_tz, box_transX")));
}

}  // namespace
}  // namespace morphe::imports
