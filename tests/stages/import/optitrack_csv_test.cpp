#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using OptitrackCsv = RecordingFolder;

const std::filesystem::path kTakes =
    std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/optitrack";

/// A body and its marker, solved and measured, and one more marker; `from` becomes `to`.
std::string take(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "Format Version,1.23,Take Name,\"A, B\",Export Frame Rate,100,Rotation Type,Quaternion,"
      "Length Units,Millimeters,Coordinate Space,Global\n"
      "\n"
      ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body,"
      "Rigid Body Marker,Rigid Body Marker,Rigid Body Marker,Marker,Marker,Marker,Marker,Marker,"
      "Marker\n"
      ",Name,Cup,Cup,Cup,Cup,Cup,Cup,Cup,Cup,\"Cup:1\",\"Cup:1\",\"Cup:1\",Cup:1,Cup:1,Cup:1,"
      "Unlabeled:7,Unlabeled:7,Unlabeled:7\n"
      ",ID,1,1,1,1,1,1,1,1,2,2,2,2,2,2,3,3,3\n"
      ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,"
      "Position,Position,Position,Position,Position,Position,Position,Position,Position\n"
      "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z,X,Y,Z,X,Y,Z\n"
      "10,0.1,0,0.6,0,0.8,100,200,300,0.1,110,200,300,111,200,300,1,2,3\n"
      "11,0.11,,,,,,,,,110,200,300,,,,,,\n"
      "15,0.149,0,0.6,0,0.8,100,200,300,0.1,110,200,300,111,200,300,1,2,3\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

TEST_F(OptitrackCsv, BodiesAndMeasuredMarkersInTheWorld) {
  const Demonstration d = read(write(take()));
  const MarkerStream& markers = *d.streams.markers;
  EXPECT_THAT(markers.names, ElementsAre("Cup:1"));
  EXPECT_THAT(markers.time, ElementsAre(0.10, 0.11, 0.15));  // of the frames, not rounded ones
  EXPECT_LT((markers.position(0, 0) - Vec3(0.111, -0.300, 0.200)).norm(), 1e-12);
  EXPECT_FALSE(is_known(markers.position(1, 0)));
  ASSERT_EQ(d.objects.size(), 1u);
  const SceneObject& cup = d.objects[0];
  EXPECT_EQ(cup.name, "Cup");
  EXPECT_THAT(cup.time, ElementsAre(0.10, 0.15));  // hidden in between
  // Turned about the vertical by 2 atan(0.6 / 0.8), and its box is centred at the marker.
  EXPECT_LT(angle_between(cup.orientation[0],
                          Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX())) * Quat(0.8, 0, 0.6, 0)),
            1e-9);
  EXPECT_LT((cup.position[0] - Vec3(0.111, -0.300, 0.200)).norm(), 1e-9);
  EXPECT_THAT(d.import_notes, Contains("3 frames are missing in 1 gap"));
  EXPECT_THAT(d.import_notes, Contains("1 unlabelled marker skipped"));
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("assumed 'x -z y' (right, forward, up)")));
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("object Cup: assumed a box of")));
}

TEST_F(OptitrackCsv, AxesMayBeOthers) {
  const Demonstration d = read(write(take()), {"x y z", "", {}});
  EXPECT_LT((d.streams.markers->position(0, 0) - Vec3(0.111, 0.200, 0.300)).norm(), 1e-12);
}

TEST_F(OptitrackCsv, EulerAnglesTurnInTheOrderOfTheirName) {
  std::string text = take("Quaternion", "XYZ");
  const auto change = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != std::string::npos;) {
      text.replace(at, from.size(), to);
    }
  };
  change("Rotation,Rotation,Rotation,Rotation", "Rotation,Rotation,Rotation,");
  change("X,Y,Z,W,X", "X,Y,Z,,X");
  change("0,0.6,0,0.8,", "90,90,0,,");
  const Demonstration d = read(write(text), {"x y z", "", {}});
  // First about x, then about the y that was turned with it: z goes to x, x to -z and then y.
  EXPECT_LT((d.objects[0].orientation[0] * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((d.objects[0].orientation[0] * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-9);
}

TEST_F(OptitrackCsv, ABodyMayBeTheWrist) {
  ImportRequest request;
  request.paths = {write(take())};
  request.name_map = write("{Cup: wrist}", "names.yaml");
  const Demonstration d = read(request);
  ASSERT_TRUE(d.streams.sensors);
  EXPECT_THAT(d.streams.sensors->names, ElementsAre("wrist"));
  EXPECT_LT((d.streams.sensors->position(0, 0) - Vec3(0.1, -0.3, 0.2)).norm(), 1e-12);
  EXPECT_FALSE(is_known(d.streams.sensors->position(1, 0)));
  EXPECT_TRUE(d.objects.empty());
  request.name_map = write("{Cup: right_wrist, Cup:1: right_index_tip}", "names.yaml");
  request.conventions.unit = "mm";  // a hand of 10 mm, which is asked about otherwise
  const Demonstration joints = read(request);
  EXPECT_THAT(joints.streams.skeleton->names, ElementsAre("right_index_tip", "right_wrist"));
  EXPECT_LT((joints.streams.skeleton->position(0, 1) - Vec3(0.1, -0.3, 0.2)).norm(), 1e-12);
  EXPECT_TRUE(is_known(joints.streams.skeleton->orientation(0, 1)));
}

/// All 21 joints of a hand as markers, in two frames `step` mm apart.
std::string marked_hand(double step) {
  std::string types = ",Type", names = ",Name", quantities = ",", axes = "Frame,Time", rows[2];
  for (int k = 0; k < 21; ++k) {
    const char* const fingers[] = {"thumb", "index", "middle", "ring", "little"};
    const char* const parts[] = {"mcp", "pip", "dip", "tip"};
    const char* const of_thumb[] = {"cmc", "mcp", "ip", "tip"};
    const int finger = (k - 1) / 4, part = (k - 1) % 4;
    const std::string name = k == 0 ? "right_wrist"
                                    : fmt::format("right_{}_{}", fingers[finger],
                                                  finger == 0 ? of_thumb[part] : parts[part]);
    for (const char* axis : {"X", "Y", "Z"}) {
      types += ",Marker";
      names += "," + name;
      quantities += ",Position";
      axes += fmt::format(",{}", axis);
    }
    for (int i = 0; i < 2; ++i) {
      rows[i] += fmt::format(",{},{},{}", 50 + step * i, 20 * finger, k == 0 ? 10 : 90 + 25 * part);
    }
  }
  return fmt::format(
      "Format Version,1.23,Export Frame Rate,100,Length Units,Millimeters\n\n{}\n{}\n,ID\n{}\n{}\n"
      "0,0{}\n1,0.01{}\n",
      types, names, quantities, axes, rows[0], rows[1]);
}

TEST_F(OptitrackCsv, AHandThatGoesAboutHasAPlace) {
  const Demonstration goes = read(write(marked_hand(80)));
  ASSERT_TRUE(goes.streams.skeleton);
  EXPECT_EQ(goes.streams.skeleton->names.size(), 21u);
  EXPECT_FALSE(goes.streams.hand);
  const Demonstration rests = read(write(marked_hand(2)));
  EXPECT_FALSE(rests.streams.skeleton);
  EXPECT_EQ(rests.streams.hand->kind, HandKind::keypoints);
  EXPECT_THAT(rests.import_notes, Contains(HasSubstr("stays in place, without an arm")));
}

TEST_F(OptitrackCsv, ErrorsSayWhere) {
  const auto error = [&](const std::string& from, const std::string& to) {
    return error_of(write(take(from, to), "take.csv"));
  };
  EXPECT_EQ(error("Global", "Local"),
            "take.csv:1: Coordinate Space: is Local; export in Global coordinates");
  EXPECT_EQ(error("Millimeters", "Ells"),
            "take.csv:1: unit: 'Ells' in the file is unknown; give --unit or `unit:`, such as mm");
  EXPECT_THAT(error("Length Units,Millimeters", "Length,Millimeters"),
              HasSubstr("unit: not in the file"));
  EXPECT_EQ(
      error("Frame,Time", "Row,Time"),
      "take.csv:10: Frame: the line 'Frame,Time' is missing; export the take with its header");
  EXPECT_EQ(error("11,0.11", "9,0.11"),
            "take.csv:9: Frame: must be greater than in the previous row");
  EXPECT_EQ(error("10,0.1,0,0.6", "10,0.1,0,6"),
            "take.csv:8: Cup.Rotation: is not a quaternion of unit length");
  EXPECT_EQ(error("111,200", "111,2o0"), "take.csv:8: Cup:1.Position: must be a number, not '2o0'");
  EXPECT_EQ(error(",1,2,3\n11", "\n11"), "take.csv:8: the row has 16 cells, the header has 19");
  EXPECT_EQ(error(",,Rotation,Rotation", ",,Rotation,Spin"), "take.csv:7: Cup.Rotation: lacks Y");
  const std::string text = take();
  for (std::size_t length = 20; length < text.size() - 60; length += 7) {
    EXPECT_NE(error_of(write(text.substr(0, length), "take.csv")), "") << length;
  }
}

// The first values by the file's own text: x, y, z in millimetres with y up.
TEST_F(OptitrackCsv, ReadsBothShippedVersions) {
  const Demonstration d = read(kTakes / "rofunc_take.csv");
  ASSERT_EQ(d.objects.size(), 3u);
  EXPECT_EQ(d.streams.markers->names.size(), 12u);
  EXPECT_EQ(d.streams.markers->time.size(), 8u);
  EXPECT_NEAR(d.streams.markers->time[4], 444 / 120.0, 1e-12);
  EXPECT_THAT(d.import_notes, Contains("440 frames are missing in 1 gap"));
  ImportRequest request;
  request.paths = {kTakes / "rofunc_take.csv"};
  request.name_map = write("{Left: left_wrist, Right: right_wrist}", "names.yaml");
  const BodyStream wrists = *read(request).streams.skeleton;
  EXPECT_LT((wrists.position(0, 0) - Vec3(-0.079610710, -0.212482422, 0.823122498)).norm(), 1e-9);
  // The markers stay where they are in the body: the order x, y, z, w of its quaternion is right.
  for (const char* body : {"Left", "Right", "Box"}) {
    const SceneObject& object = *find_object(d.objects, body);
    for (std::size_t k = 0; k < 12; ++k) {
      if (!d.streams.markers->names[k].starts_with(body)) continue;
      const auto in_body = [&](std::size_t i) {
        return Vec3(object.orientation[i].conjugate() *
                    (d.streams.markers->position(i, k) - object.position[i]));
      };
      EXPECT_LT((in_body(0) - in_body(7)).norm(), 0.005) << d.streams.markers->names[k];
    }
  }
  const Demonstration cmu = read(kTakes / "cmu_take.csv");
  ASSERT_EQ(cmu.objects.size(), 1u);
  EXPECT_EQ(cmu.objects[0].time.size(), 250u);
  EXPECT_NEAR(cmu.objects[0].position[0].z(), 0.0192, 0.001);  // on the floor
}

/// As Motive 3 exports a skeleton with its markers: both are called P1:RFArm.
TEST_F(OptitrackCsv, BoneAndMarkerOfOneName) {
  const Demonstration d = read(write(
      "Format Version,1.25,Export Frame Rate,100,Rotation Type,Quaternion,Length Units,Meters,"
      "Coordinate Space,Global\n\n"
      ",Type,Bone,Bone,Bone,Bone,Bone,Bone,Bone,Marker,Marker,Marker\n"
      ",Name,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,P1:RFArm,"
      "P1:RFArm\n,ID,1,1,1,1,1,1,1,2,2,2\n,Parent,Root,Root,Root,Root,Root,Root,Root,,,\n"
      ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,"
      "Position\nFrame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z\n"
      "0,0,0,0,0,1,0.1,0.2,0.3,0.4,0.5,0.6\n1,0.01,0,0,0,1,0.1,0.2,0.3,0.4,0.5,0.6\n"));
  EXPECT_THAT(d.streams.skeleton->names, ElementsAre("P1:RFArm"));
  EXPECT_THAT(d.streams.markers->names, ElementsAre("P1:RFArm_marker"));
  EXPECT_LT((d.streams.markers->position(0, 0) - Vec3(0.4, -0.6, 0.5)).norm(), 1e-12);
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("the marker is called P1:RFArm_marker")));
}

}  // namespace
}  // namespace morphe::imports
