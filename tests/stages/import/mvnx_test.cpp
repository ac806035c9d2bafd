#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;
using Mvnx = RecordingFolder;

std::string segment(const std::string& label, const std::string& points = "") {
  return fmt::format("<segment label=\"{}\"><points>{}</points></segment>\n", label, points);
}

/// A right arm to the right, palm down, with an index finger bent by `angle` at its last joint.
std::string mvnx(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "<?xml version=\"1.0\"?>\n<mvnx version=\"4\">\n"
      "<subject label=\"Suit 3\" frameRate=\"60\">\n<segments>\n" +
      segment("Pelvis") + segment("RightUpperArm") + segment("RightForeArm") +
      segment("RightHand", "<point label=\"pRightTopOfHand\"><pos_b>0 -0.1 0</pos_b></point>") +
      "</segments>\n<fingerTrackingSegmentsRight>\n" + segment("RightSecondMC") +
      segment("RightSecondPP") + segment("RightSecondMP") +
      segment("RightSecondDP",
              "<point label=\"pRightSecondTip\"><pos_b>0 -0.02 0</pos_b></point>") +
      "</fingerTrackingSegmentsRight>\n<frames>\n"
      "<frame time=\"0\" type=\"tpose\"><position>bad</position></frame>\n";
  for (const int index : {7, 8, 10}) {
    text += fmt::format(
        "<frame time=\"{}\" index=\"{}\" type=\"normal\">\n"
        "<orientation>1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0</orientation>\n"
        "<position>0 0 1 0.1 -0.2 1.4 0.1 -0.5 1.4 0.1 -0.75 1.4</position>\n"
        "<orientationFingersRight>1 0 0 0 1 0 0 0 1 0 0 0 0.8 -0.6 0 0</orientationFingersRight>\n"
        "<positionFingersRight>0.12 -0.76 1.4 0.12 -0.84 1.4 0.12 -0.88 1.4 0.12 -0.90 1.4"
        "</positionFingersRight>\n</frame>\n",
        index * 17, index);
  }
  text += "</frames>\n</subject>\n</mvnx>\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

TEST_F(Mvnx, SegmentsBeginAtTheirJoints) {
  const Demonstration d = read(write(mvnx(), "walk.mvnx"));
  EXPECT_EQ(d.subject, "Suit 3");
  const BodyStream& body = *d.streams.skeleton;
  EXPECT_EQ(body.time, (std::vector<double>{0, 1 / 60.0, 3 / 60.0}));
  const auto joint = [&](const std::string& name) {
    const auto at = std::ranges::find(body.names, name) - body.names.begin();
    return body.position(0, static_cast<std::size_t>(at));
  };
  // X forward and Y left become Y and -X.
  EXPECT_LT((joint("right_shoulder") - Vec3(0.2, 0.1, 1.4)).norm(), 1e-12);
  EXPECT_LT((joint("right_elbow") - Vec3(0.5, 0.1, 1.4)).norm(), 1e-12);
  EXPECT_LT((joint("right_wrist") - Vec3(0.75, 0.1, 1.4)).norm(), 1e-12);
  EXPECT_LT((joint("right_index_mcp") - Vec3(0.84, 0.12, 1.4)).norm(), 1e-12);
  EXPECT_LT((joint("right_index_dip") - Vec3(0.90, 0.12, 1.4)).norm(), 1e-12);
  // Turned by -2 atan(0.6 / 0.8) about x: -y goes to (0, -0.28, 0.96).
  EXPECT_LT((joint("right_index_tip") - Vec3(0.90 + 0.02 * 0.28, 0.12, 1.4 + 0.02 * 0.96)).norm(),
            1e-12);
  // The hand's axes: fingers to the right, the thumb forward, out of the palm downwards.
  const auto hand =
      static_cast<std::size_t>(std::ranges::find(body.names, "right_hand") - body.names.begin());
  const Eigen::Matrix3d axes = body.orientation(0, hand).toRotationMatrix();
  EXPECT_LT((axes.col(0) + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((axes.col(1) - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((axes.col(2) - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_THAT(d.import_notes, Contains("1 frame of the calibration skipped"));
}

TEST_F(Mvnx, TwoPeopleAreSaid) {
  const Demonstration d = read(
      write(mvnx("</subject>", "</subject><subject label=\"B\" frameRate=\"60\"/>"), "two.mvnx"));
  EXPECT_THAT(d.import_notes, Contains("the file has 2 people; the first, Suit 3, is used"));
}

TEST_F(Mvnx, ErrorsSayWhere) {
  const auto error = [&](const std::string& from, const std::string& to) {
    return error_of(write(mvnx(from, to), "m.mvnx"));
  };
  EXPECT_EQ(error("frameRate=\"60\"", "frameRate=\"x\""),
            "m.mvnx:3: subject.frameRate: must be a number, not 'x'");
  EXPECT_EQ(error("frameRate=\"60\"", ""), "m.mvnx:3: subject.frameRate: is missing");
  EXPECT_EQ(error("0 0 1 0.1", "0 0 0.1"), "m.mvnx:20: position: must have 12 numbers, not 11");
  EXPECT_EQ(error("0 0 1 0.1", "0 0 ? 0.1"), "m.mvnx:20: position: value 3 is not a number");
  EXPECT_EQ(error("<orientation>1", "<orientation>3"),
            "m.mvnx:19: orientation: Pelvis: is not a quaternion of unit length");
  EXPECT_EQ(error("index=\"8\"", "index=\"6\""),
            "m.mvnx:24: frame.index: must be greater than in the previous frame");
  const std::string text = mvnx();
  for (std::size_t length = 40; length < text.size() - 10; length += 23) {
    EXPECT_THAT(error_of(write(text.substr(0, length), "m.mvnx")), HasSubstr("m.mvnx:")) << length;
  }
}

}  // namespace
}  // namespace morphe::imports
