#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/human/glove.hpp"
#include "core/motion/input_error.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kDegree = 3.14159265358979323846 / 180;

class LibertyCsv : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("morphe_liberty_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// A file on its own; axes as the world's unless said otherwise.
  Demonstration read(const std::string& text, Conventions conventions = {"x y z", "", {}}) const {
    ImportRequest request;
    request.paths = {write("arm.csv", text)};
    request.conventions = std::move(conventions);
    request.conventions.forward = ForwardSource::recorded;
    return read(request);
  }
  static Demonstration read(const ImportRequest& request) {
    Demonstration result;
    import_recordings(request, [&](Demonstration&& d) { result = std::move(d); });
    return result;
  }
  std::string error_of(const std::string& text,
                       const Conventions& conventions = {"x y z", "", {}}) const {
    try {
      read(text, conventions);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "arm.csv").string().size());
    }
    return "no error";
  }

  std::filesystem::path folder_;
};

const std::string kLibertyHeader =
    "time_s,wrist_x_m,wrist_y_m,wrist_z_m,wrist_qw,wrist_qx,wrist_qy,wrist_qz\n";

TEST_F(LibertyCsv, ReadsPosesInAnyOrderAndUnit) {
  const Demonstration d = read(
      "elbow_z_mm,elbow_qw,time_s,elbow_x_mm,wrist_qw,wrist_qx,wrist_qy,wrist_qz,elbow_y_mm,"
      "wrist_z_in,wrist_y_in,wrist_x_in,elbow_qx,elbow_qy,elbow_qz,button\n"
      "300,1,0.5,100,0.5,0.5,0.5,0.5,200,3,2,1,0,0,0,7\n"
      ",1,0.504,,0.6,0,0.8,0,,3,2,1,0,0,0,7\n");
  const BodyStream& bodies = *d.streams.sensors;
  EXPECT_THAT(bodies.names, ElementsAre("elbow", "wrist"));
  EXPECT_THAT(bodies.time, ElementsAre(0.5, 0.504));
  EXPECT_LT((bodies.position(0, 0) - Vec3(0.1, 0.2, 0.3)).norm(), 1e-15);
  EXPECT_LT((bodies.position(0, 1) - 0.0254 * Vec3(1, 2, 3)).norm(), 1e-15);
  EXPECT_FALSE(is_known(bodies.position(1, 0)));
  EXPECT_TRUE(is_known(bodies.orientation(1, 0)));
  EXPECT_LT(angle_between(bodies.orientation(0, 1), Quat(0.5, 0.5, 0.5, 0.5)), 1e-12);
  EXPECT_LT(angle_between(bodies.orientation(1, 1), Quat(0.6, 0, 0.8, 0)), 1e-12);
  EXPECT_THAT(d.import_notes,
              ElementsAre(HasSubstr("columns skipped: button"), HasSubstr("no calibration pose")));
}

/// Recorded x forward, y left, z up: right is -y, forward is x.
TEST_F(LibertyCsv, TurnsPositionsAndAnglesIntoTheWorld) {
  const Demonstration d = read(
      "frame,wrist_x,wrist_y,wrist_z,wrist_azimuth_deg,wrist_elevation_deg,wrist_roll_deg\n"
      "10,1,2,3,90,0,0\n12,1,2,3,0,90,0\n13,1,2,3,0,0,90\n14,1,2,3,30,40,50\n",
      {"-y x z", "cm", 240.0});
  const BodyStream& wrist = *d.streams.sensors;
  EXPECT_LT((wrist.position(0, 0) - Vec3(-0.02, 0.01, 0.03)).norm(), 1e-15);
  EXPECT_THAT(wrist.time, ElementsAre(0.0, 2 / 240.0, 3 / 240.0, 4 / 240.0));
  // The sensor's x axis, recorded: along y, along -z, along x.
  EXPECT_LT((wrist.orientation(0, 0) * Vec3::UnitX() - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((wrist.orientation(1, 0) * Vec3::UnitX() - Vec3(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((wrist.orientation(2, 0) * Vec3::UnitX() - Vec3(0, 1, 0)).norm(), 1e-12);
  EXPECT_LT((wrist.orientation(2, 0) * Vec3::UnitY() - Vec3(0, 0, 1)).norm(), 1e-12);
  // Rz(30) Ry(40) Rx(50), first column, by hand.
  const double a = 30 * kDegree, e = 40 * kDegree;
  const Vec3 x(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), -std::sin(e));
  EXPECT_LT((wrist.orientation(3, 0) * Vec3::UnitX() - Vec3(-x.y(), x.x(), x.z())).norm(), 1e-12);
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("computed from the frame numbers, 240")));
}

TEST_F(LibertyCsv, ReadsGloveAndCalibrationPoseByAManifest) {
  write("arm.csv", kLibertyHeader + "0,1,2,3,1,0,0,0\n0.1,1,2,3,1,0,0,0\n");
  write("glove.csv",
        "IndexMPJ_deg,time_s,ThumbRotate_raw,PinkieDIJ_rad\n"
        "90,0,0.21,0.5\n45,0.01,0,\n");
  write("pose.csv",
        "time_s,wrist_x_mm,wrist_y_mm,wrist_z_mm,wrist_qw,wrist_qx,wrist_qy,wrist_qz,"
        "middle_mcp_x_mm,middle_mcp_y_mm,middle_mcp_z_mm,index_mcp_x_mm,index_mcp_y_mm,"
        "index_mcp_z_mm,little_mcp_x_mm,little_mcp_y_mm,little_mcp_z_mm,joint_x_mm,joint_y_mm,"
        "joint_z_mm\n0,0,0,50,1,0,0,0,0,90,0,0,90,20,0,80,-50,0,0,0\n");
  write("flat.csv", "time_s,IndexMPJ_deg\n0,3\n");
  write("names.yaml", "joint: elbow\n");  // a point of a name that says nothing
  write("raw.yaml",
        "ThumbRotate: {raw_low: 0, angle_low: -60 deg, raw_high: 0.42, angle_high: 100 deg}\n");
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {
      write("recordings.yaml",
            "axes: x y z\nrecordings:\n"
            "  - {file: arm.csv, glove: glove.csv, static_trial: pose.csv, glove_static_trial: "
            "flat.csv, glove_calibration: raw.yaml, names: names.yaml}\n")};
  const Demonstration d = read(request);
  const HandStream& glove = *d.streams.hand;
  EXPECT_EQ(glove.kind, HandKind::glove);
  ASSERT_EQ(glove.angles.cols(), 22);
  EXPECT_THAT(glove.names, testing::ElementsAreArray(human::kGloveSensors));
  EXPECT_NEAR(glove.angles(0, 4), 90 * kDegree, 1e-12);
  EXPECT_NEAR(glove.angles(0, 0), 20 * kDegree, 1e-12);
  EXPECT_NEAR(glove.angles(1, 0), -60 * kDegree, 1e-12);
  EXPECT_EQ(glove.angles(0, 17), 0.5);
  EXPECT_TRUE(std::isnan(glove.angles(1, 17)));
  EXPECT_TRUE(std::isnan(glove.angles(0, 1)));
  EXPECT_THAT(d.import_notes,
              Contains(HasSubstr("glove.csv: glove sensors without a column: ThumbMPJ, ThumbIJ")));
  EXPECT_NEAR(d.calibration.hand->angles(0, 4), 3 * kDegree, 1e-12);
  EXPECT_THAT(d.calibration.markers->names,
              ElementsAre("middle_mcp", "index_mcp", "little_mcp", "elbow"));
  // Nobody digitised the wrist: its sensor has no offset, and that is said.
  EXPECT_THAT(d.sensor_offsets->sensors, IsEmpty());
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("no point wrist was digitised")));
}

/// A sensor turned by 90 degrees about Z; the hand points forward, thumb up.
TEST_F(LibertyCsv, FindsTheSensorOffsetsOfTheCalibrationPose) {
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {write("arm.csv", kLibertyHeader + "0,1,2,3,1,0,0,0\n")};
  request.static_trial = write(
      "pose.csv",
      "time_s,wrist_x_mm,wrist_y_mm,wrist_z_mm,wrist_joint_x_mm,wrist_joint_y_mm,wrist_joint_z_mm,"
      "wrist_azimuth_deg,wrist_elevation_deg,wrist_roll_deg,middle_mcp_x_mm,middle_mcp_y_mm,"
      "middle_mcp_z_mm,index_mcp_x_mm,index_mcp_y_mm,index_mcp_z_mm,little_mcp_x_mm,"
      "little_mcp_y_mm,little_mcp_z_mm\n"
      "0,10,20,80,40,20,30,90,0,0,40,110,30,40,110,50,40,100,-20\n");
  request.conventions.axes = "x y z";
  const Demonstration d = read(request);
  EXPECT_THAT(d.import_notes, IsEmpty());
  EXPECT_THAT(d.calibration.markers->names, Contains("wrist"));
  ASSERT_THAT(d.sensor_offsets->sensors, ElementsAre("wrist"));
  EXPECT_LT((d.sensor_offsets->joint_in_sensor[0] - Vec3(0, -0.03, -0.05)).norm(), 1e-12);
  Eigen::Matrix3d sensor_from_hand;
  sensor_from_hand << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_LT((d.sensor_offsets->sensor_from_segment[0].toRotationMatrix() - sensor_from_hand).norm(),
            1e-12);
}

TEST_F(LibertyCsv, RepairsWhatItSays) {
  const Demonstration d =
      read("\xEF\xBB\xBF" + kLibertyHeader +
           "0,1,2,3,1.001,0,0,0\r\n0.1,NaN,,nan,0,0,0,0\n0.2,1,2,3,,,,\n\n,,,\n");
  EXPECT_EQ(d.streams.sensors->time.size(), 3u);
  EXPECT_NEAR(d.streams.sensors->orientation(0, 0).norm(), 1, 1e-15);
  EXPECT_FALSE(is_known(d.streams.sensors->orientation(1, 0)));
  EXPECT_FALSE(is_known(d.streams.sensors->orientation(2, 0)));
  EXPECT_THAT(
      d.import_notes,
      Contains(HasSubstr("1 quaternions normalised; their norm differed from 1 by up to 0.001")));
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("1 quaternions are zero")));
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("mixed line endings")));
  const Demonstration unseen = read(kLibertyHeader + "0,,,,,,,\n0.1,NaN,NaN,NaN,,,,\n");
  EXPECT_THAT(unseen.import_notes, Contains(HasSubstr("wrist is never visible")));
}

TEST_F(LibertyCsv, RefusesWhatItDoesNotUnderstand) {
  const std::string row = "0,1,2,3,1,0,0,0\n";
  const auto header_with = [](const std::string& from, const std::string& to) {
    std::string header = kLibertyHeader;
    return header.replace(header.find(from), from.size(), to);
  };
  EXPECT_EQ(error_of(kLibertyHeader), ":1: ends before the first row");
  EXPECT_EQ(error_of(kLibertyHeader + row + "0.1,1,2,3,1,0,0\n"),
            ":3: the row has 7 cells, the header has 8");
  EXPECT_EQ(error_of(kLibertyHeader + row + "0.1,1,2,3\n"),
            ":3: the row has 4 cells, the header has 8");
  EXPECT_EQ(error_of(kLibertyHeader + row + "-1,1,2,3,1,0,0,0\n"),
            ":3: time_s: must be greater than in the previous row");
  EXPECT_EQ(error_of(kLibertyHeader + row + "9e9,1,2,3,1,0,0,0\n"),
            ":3: time_s: increases by more than one hour");
  EXPECT_EQ(error_of(kLibertyHeader + ",1,2,3,1,0,0,0\n"), ":2: time_s: is empty");
  EXPECT_EQ(error_of(kLibertyHeader + "0,1,x,3,1,0,0,0\n"),
            ":2: wrist_y_m: must be a number, not 'x'");
  EXPECT_EQ(error_of(kLibertyHeader + "0,1,2,3,1,1,0,0\n"),
            ":2: wrist: its quaternion has norm 1.414, must be 1");
  EXPECT_THAT(error_of(kLibertyHeader + "0,1000,2,3,1,0,0,0\n"),
              HasSubstr(": unit: a sensor is 1e+03 m"));
  EXPECT_EQ(error_of(header_with("wrist_y_m", "wrist_x_m") + row),
            ":1: wrist_y: the column is missing");
  EXPECT_EQ(error_of(header_with("wrist_y_m", "wrist_x_mm") + row),
            ":1: wrist_x_mm: wrist has this column twice");
  EXPECT_EQ(error_of(header_with("wrist_y_m", "wrist_w_m") + row),
            ":1: wrist_y: the column is missing");
  EXPECT_EQ(error_of(header_with("wrist_qz", "wrist_qq") + row),
            ":1: wrist_qz: the column is missing");
  EXPECT_EQ(error_of(header_with("wrist_y_m", "wrist_y_cm") + row),
            ":1: wrist_y_cm: has another unit than the other columns of the body");
  EXPECT_EQ(error_of(header_with("wrist_qz", "wrist_roll_deg") + row),
            ":1: wrist_roll_deg: the body has both a quaternion and Euler angles; remove one");
  EXPECT_THAT(error_of(kLibertyHeader + row, {}), HasSubstr(": axes: the file does not state"));
  const std::string bare = "time_s,w_x,w_y,w_z,w_qw,w_qx,w_qy,w_qz\n" + row;
  EXPECT_THAT(error_of(bare), HasSubstr(": unit: not in the file"));
  const std::string frames = header_with("time_s", "frame") + row;
  EXPECT_THAT(error_of(frames), HasSubstr(": rate: not in the file"));
  EXPECT_EQ(error_of("time_s,ThumbRotate_deg,IndexMPJ\n0,1,2\n"),
            ":1: IndexMPJ: unit missing: must end in _deg, _rad or _raw");
  EXPECT_EQ(error_of("time_s,IndexMPJ_deg,IndexMPJ_rad\n0,1,1\n"),
            ":1: IndexMPJ_rad: the sensor appears twice");
  EXPECT_EQ(error_of("time_s,IndexMPJ_rad\n0,80\n"),
            ":2: IndexMPJ_rad: is more than 180 degrees; is the unit correct?");
  EXPECT_THAT(error_of("time_s,IndexMPJ_raw\n0,80\n"),
              HasSubstr("raw counts need two calibration"));
  EXPECT_THAT(error_of(""), HasSubstr("is empty; "));
}

TEST_F(LibertyCsv, RefusesAGloveWhereNoneBelongs) {
  write("arm.csv", kLibertyHeader + "0,1,2,3,1,0,0,0\n");
  write("both.csv", "time_s,IndexMPJ_deg,ThumbRotate_deg\n0,1,2\n");
  const auto error_with = [&](const std::string& entry) -> std::string {
    ImportRequest request;
    request.conventions.forward = ForwardSource::recorded;
    request.paths = {write("m.yaml", "axes: x y z\nrecordings:\n  - {" + entry + "}\n")};
    try {
      read(request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_with("file: arm.csv, glove: both.csv"), "no error");
  EXPECT_THAT(error_with("file: both.csv, glove: both.csv"),
              HasSubstr("already has the glove sensors"));
  EXPECT_THAT(error_with("file: both.csv, glove: arm.csv"),
              HasSubstr("has no column of a glove sensor"));
  write("names.yaml", "pinky: little\n");
  EXPECT_THAT(error_with("file: arm.csv, names: names.yaml"),
              HasSubstr("'pinky' is to be renamed but is not in the recording"));
  write("raw.yaml", "Thumb: {raw_low: 0, angle_low: 0, raw_high: 1, angle_high: 1}\n");
  EXPECT_THAT(error_with("file: both.csv, glove_calibration: raw.yaml"),
              HasSubstr("raw.yaml:1: Thumb: is not a sensor"));
  write("raw.yaml", "IndexMPJ: {raw_low: 1, angle_low: 0, raw_high: 1, angle_high: 1}\n");
  EXPECT_THAT(error_with("file: both.csv, glove_calibration: raw.yaml"),
              HasSubstr("raw.yaml:1: IndexMPJ: raw_low and raw_high must differ"));
}

}  // namespace
}  // namespace morphe::imports
