#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "stages/import/guess/heading.hpp"
#include "stages/import/guess/unresolved_import.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::size_t joint_of(const BodyStream& body, const std::string& name) {
  for (std::size_t k = 0; k < body.names.size(); ++k) {
    if (body.names[k] == name) return k;
  }
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

/// An arm that says which way is up and right; one row of numbers a frame. `order` is that of the
/// rotations of every joint: "ZYX" = the channels Zrotation Yrotation Xrotation.
std::string body(const std::string& order, const std::vector<std::string>& rows,
                 const std::string& frame_time = "0.01", const std::string& more = "") {
  std::string turns;
  for (const char axis : order) turns += fmt::format(" {}rotation", axis);
  const std::string channels = fmt::format("CHANNELS 3{}\n", turns);
  std::string text =
      "HIERARCHY\nROOT hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition" + turns +
      "\n";
  for (const char* side : {"left", "right"}) {
    text += fmt::format("JOINT {0}_shoulder\n{{\nOFFSET {1}2 5 0\n{2}", side,
                        side[0] == 'l' ? "" : "-", channels);
    if (side[0] == 'r') {
      text += fmt::format(
          "JOINT right_elbow\n{{\nOFFSET 0 -3 0\n{0}JOINT right_wrist\n{{\nOFFSET 0 -2.5 0.5\n"
          "{0}End Site\n{{\nOFFSET 0 -1 0\n}}\n}}\n}}\n",
          channels);
    } else {
      text += "End Site\n{\nOFFSET 1 0 0\n}\n";
    }
    text += "}\n";
  }
  text += more + "}\nMOTION\n" + fmt::format("Frames: {}\n", rows.size()) +
          fmt::format("Frame Time: {}\n", frame_time);
  for (const std::string& row : rows) text += row + "\n";
  return text;
}
/// Root position and rotation, left shoulder, right shoulder, elbow, wrist.
const std::string kRest = "0 0 0  0 0 0  0 0 0  0 0 0  0 0 0  0 0 0";
const Conventions kSkeleton{"x y z", "0.1", std::nullopt};

using Bvh = RecordingFolder;

class BvhOrder : public RecordingFolder, public testing::WithParamInterface<const char*> {};

// By Rodrigues' formula, matrix by matrix, in the order of the channels.
TEST_P(BvhOrder, TurnsInTheOrderOfTheChannels) {
  const std::string order = GetParam();
  const double angles[][3] = {{10, -20, 30}, {40, 50, -60}, {-70, 15, 25}, {5, 95, -35}};
  const auto text = [&](std::size_t joint) {
    return fmt::format(" {}", fmt::join(angles[joint], " "));
  };
  const std::string row = "1 2 3" + text(0) + " 0 0 0" + text(1) + text(2) + text(3);
  const Demonstration d = read(write(body(order, {row}), "order.bvh"), kSkeleton);
  const auto turn = [&](std::size_t joint) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 axis = Vec3::Unit(order[k] - 'X');
      const double angle = angles[joint][k] * M_PI / 180;
      Eigen::Matrix3d cross;
      cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
      matrix = matrix * (Eigen::Matrix3d::Identity() + std::sin(angle) * cross +
                         (1 - std::cos(angle)) * cross * cross);
    }
    return matrix;
  };
  const Eigen::Matrix3d root = turn(0), shoulder = root * turn(1), elbow = shoulder * turn(2),
                        wrist = elbow * turn(3);
  const Vec3 at_shoulder = Vec3(1, 2, 3) + root * Vec3(-2, 5, 0);
  const Vec3 at_elbow = at_shoulder + shoulder * Vec3(0, -3, 0);
  const Vec3 at_wrist = at_elbow + elbow * Vec3(0, -2.5, 0.5);
  const BodyStream& b = *d.streams.skeleton;
  const auto expect = [&](const char* name, const Vec3& position, const Eigen::Matrix3d& axes) {
    const std::size_t k = joint_of(b, name);
    EXPECT_LT((b.position(0, k) - 0.1 * position).norm(), 1e-14) << name;
    EXPECT_LT((b.orientation(0, k).toRotationMatrix() - axes).norm(), 1e-14) << name;
  };
  expect("hips", Vec3(1, 2, 3), root);
  expect("right_shoulder", at_shoulder, shoulder);
  expect("right_elbow", at_elbow, elbow);
  expect("right_wrist", at_wrist, wrist);
  expect("right_wrist_end", at_wrist + wrist * Vec3(0, -1, 0), wrist);
}
INSTANTIATE_TEST_SUITE_P(, BvhOrder, testing::Values("XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"));

TEST_F(Bvh, TakesChannelsInAnyOrderAndPositionsOnAnyJoint) {
  const std::string text =
      "\n  hierarchy\n\tRoot  a body {\r\nchannels 4 Zrotation xPOSITION Yrotation zposition\n"
      "OFFSET 7 8 9\nJOINT arm{OFFSET 0 4 0 CHANNELS 1 Yposition}\n}\n"
      "Motion\n Frames :2\nframe time:.5\n\n90 1 0 2\t5\n\n0 1 90 2 -3  \n\n";
  const Demonstration d = read(write(text, "any.bvh"), {"x y z", "0.1", std::nullopt});
  const BodyStream& b = *d.streams.skeleton;
  EXPECT_THAT(b.names, ElementsAre("a body", "arm"));
  EXPECT_THAT(b.parents, ElementsAre("", "a body"));
  EXPECT_THAT(b.time, ElementsAre(0, 0.5));
  // x and z come from the channels, y stays the OFFSET's; so does what the arm has no channel for.
  EXPECT_LT((b.position(0, 0) - Vec3(0.1, 0.8, 0.2)).norm(), 1e-15);
  EXPECT_LT((b.position(0, 1) - Vec3(-0.4, 0.8, 0.2)).norm(), 1e-15);  // Rz(90) (0, 5, 0)
  EXPECT_LT((b.position(1, 1) - Vec3(0.1, 0.5, 0.2)).norm(), 1e-15);
  EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr("OFFSET (7 8 9), which is not added")));
}

TEST_F(Bvh, FindsTheAxesAndTurnsTheSubjectToFaceY) {
  // At rest: y is up, -x is right (so z is forward). In the frame the body is turned by 90 degrees
  // about y: it faces x, the left.
  const std::string row = "10 20 30  0 90 0  0 0 0  0 0 0  0 0 0  0 0 0";
  Demonstration d = read(write(body("XYZ", {row}), "axes.bvh"), {"", "0.1", std::nullopt});
  align_heading({}, d);
  const BodyStream& b = *d.streams.skeleton;
  const Vec3 left = b.position(0, joint_of(b, "left_shoulder"));
  const Vec3 right = b.position(0, joint_of(b, "right_shoulder"));
  EXPECT_LT((right - left - Vec3(0.4, 0, 0)).norm(), 1e-14);
  EXPECT_NEAR(b.position(0, 0).z(), 2.0, 1e-14);
  // The wrist is 0.5 in front of the elbow: the body's z is the world's Y.
  const Vec3 forearm =
      b.position(0, joint_of(b, "right_wrist")) - b.position(0, joint_of(b, "right_elbow"));
  EXPECT_LT((forearm - Vec3(0, 0.05, -0.25)).norm(), 1e-14);
  EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr("'-x z y' (right, forward, up)")));
  EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr("faces 90 degrees away")));
}

TEST_F(Bvh, AsksForWhatItCannotTell) {
  const auto file = [&](const std::string& row) { return write(body("XYZ", {row}), "ask.bvh"); };
  EXPECT_THAT(error_of(file(kRest)), HasSubstr("ask.bvh: unit: "));
  EXPECT_THAT(error_of(file(kRest), {"", "m", std::nullopt}),
              HasSubstr("ask.bvh: unit: implausible"));
  EXPECT_THAT(error_of(file(kRest), {"", "0.01", std::nullopt}), HasSubstr("unit: implausible"));
  // Recorded lying, though the rest skeleton stands.
  EXPECT_THAT(
      error_of(file("0 0 0  90 0 0  0 0 0  0 0 0  0 0 0  0 0 0"), {"", "0.1", std::nullopt}),
      HasSubstr("points along y in the rest skeleton, but along z in the recording; give --axes or "
                "`axes:`"));
  // Leaning to the side so far that the shoulders stand above each other.
  EXPECT_THAT(
      error_of(file("0 0 0  0 0 46  0 0 0  0 0 0  0 0 0  0 0 0"), {"", "0.1", std::nullopt}),
      HasSubstr("points along y in the rest skeleton, but along -x in the recording"));
  std::string askew = body("XYZ", {kRest});
  askew.replace(askew.find("OFFSET -2 5 0"), 13, "OFFSET -2 5 9");
  EXPECT_THAT(error_of(write(askew, "ask.bvh"), {"", "0.1", std::nullopt}),
              HasSubstr("the trunk (root to shoulders) is not within 15"));
  std::string unnamed = body("XYZ", {kRest});
  unnamed.replace(unnamed.find("left_shoulder"), 13, "Schulter_links");
  EXPECT_THAT(error_of(write(unnamed, "ask.bvh"), {"", "0.1", std::nullopt}),
              HasSubstr("no joints are named left_shoulder and right_shoulder"));
  EXPECT_THAT(error_of(write(unnamed, "ask.bvh"), {"x x y", "0.1", std::nullopt}),
              HasSubstr("axes: must contain each of x, y and z once"));
}

TEST_F(Bvh, RowsCountNotWhatTheHeaderSays) {
  std::string text = body("XYZ", {kRest, kRest, kRest});
  text.replace(text.find("Frames: 3"), 9, "Frames: 7");
  const Demonstration fewer = read(write(text, "rows.bvh"), kSkeleton);
  EXPECT_EQ(fewer.streams.skeleton->time.size(), 3u);
  EXPECT_THAT(fewer.import_notes,
              testing::Contains("'Frames:' is 7, but the file has 3 frames; all are used"));
  text.replace(text.find("Frames: 7"), 9, "Frames: 1");
  EXPECT_EQ(read(write(text, "rows.bvh"), kSkeleton).streams.skeleton->time.size(), 3u);
}

TEST_F(Bvh, AFirstFrameThatIsOnlyAPoseIsLeftOut) {
  const std::string arm_up = "0 0 0  0 0 0  0 0 0  0 0 90  0 0 0  0 0 0";
  const std::string slow = "0 0 0  0 0 0  0 0 0  0 0 2  0 0 0  0 0 0";
  const auto frames = [&](const std::vector<std::string>& rows) {
    return read(write(body("XYZ", rows), "pose.bvh"), kSkeleton);
  };
  const Demonstration d = frames({arm_up, kRest, slow, kRest});
  EXPECT_THAT(d.streams.skeleton->time, ElementsAre(0.01, 0.02, 0.03));
  EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr("first frame skipped")));
  const BodyStream& b = *d.streams.skeleton;
  EXPECT_LT((b.position(0, joint_of(b, "right_elbow")) - Vec3(-0.2, 0.2, 0)).norm(), 1e-15);
  // A movement that is as fast throughout is none.
  EXPECT_EQ(frames({arm_up, kRest, arm_up, kRest}).streams.skeleton->time.size(), 4u);
  EXPECT_EQ(frames({slow, kRest, slow, kRest}).streams.skeleton->time.size(), 4u);
}

TEST_F(Bvh, ARateMayBeGiven) {
  Conventions given = kSkeleton;
  given.rate_hz = 50;
  const Demonstration d = read(write(body("XYZ", {kRest, kRest}), "rate.bvh"), given);
  EXPECT_DOUBLE_EQ(d.streams.skeleton->time[1], 0.02);
  EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr("the given 50 is used")));
  const auto broken = write(body("XYZ", {kRest, kRest}, "0"), "rate.bvh");
  EXPECT_DOUBLE_EQ(read(broken, given).streams.skeleton->time[1], 0.02);
}

TEST_F(Bvh, BrokenFilesAreNamedWithTheirLine) {
  const std::string good = body("XYZ", {kRest, kRest});
  EXPECT_EQ(error_of(write(good, "x.bvh"), kSkeleton), "no error");
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string text = good;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), now);
    return error_of(write(text, "x.bvh"), kSkeleton);
  };
  const auto at = [&](std::size_t line, const std::string& rest) {
    return fmt::format("x.bvh:{}: {}", line, rest);
  };
  EXPECT_THAT(error_of(write("", "x.bvh"), kSkeleton), HasSubstr("x.bvh: is empty; "));
  EXPECT_EQ(error_of(write("HIERARCHY", "x.bvh"), kSkeleton), at(1, "ROOT: expected here, not ''"));
  EXPECT_EQ(with("ROOT hips", "JOINT hips"), at(2, "ROOT: expected here, not 'JOINT'"));
  EXPECT_EQ(with("ROOT hips", "ROOT "), at(2, "a joint has no name"));
  EXPECT_EQ(with("{", "OFFSET"), at(3, "{: expected here, not 'OFFSET'"));
  EXPECT_EQ(with("OFFSET 2 5 0", "OFFSET 2 5"), at(9, "OFFSET: must be a number, not 'CHANNELS'"));
  EXPECT_EQ(with("OFFSET 2 5 0", "OFFSET nan 5 0"), at(8, "OFFSET: must be a number, not 'nan'"));
  EXPECT_EQ(with("OFFSET 2 5 0\n", ""), at(13, "left_shoulder: has no OFFSET"));
  EXPECT_EQ(with("CHANNELS 3", "CHANNELS 7"),
            at(9, "CHANNELS: must be a whole number from 0 to 6"));
  EXPECT_EQ(with("CHANNELS 3", "CHANNELS 2"),
            at(9, "left_shoulder: 'Zrotation' is not allowed here"));
  EXPECT_EQ(with("CHANNELS 3", "CHANNELS 4"), at(10, "CHANNELS: 'End' is not a channel"));
  EXPECT_EQ(with("3 Xrotation Yrotation", "3 Xrotation xrotation"),
            at(9, "CHANNELS: xrotation appears twice"));
  EXPECT_EQ(with("JOINT right_elbow", "JOINT left_shoulder"),
            at(19, "left_shoulder: the joint appears twice"));
  EXPECT_EQ(with("JOINT right_elbow", "KNEE right_elbow"),
            at(19, "right_shoulder: 'KNEE' is not allowed here"));
  EXPECT_EQ(with("MOTION", "MOTIONS"), at(35, "MOTION: expected here, not 'MOTIONS'"));
  EXPECT_EQ(with("Frames: 2", "Frames: x"), at(36, "Frames: must be a number, not 'x'"));
  EXPECT_EQ(with("Frames: 2", "Frames: 1.5"), at(36, "Frames: must be a whole number"));
  EXPECT_EQ(with("Frames: 2", "Frame: 2"), at(36, "Frames: 'Frames:' expected, not 'Frame: 2'"));
  EXPECT_EQ(with("Frame Time: 0.01\n", ""),
            at(37, "Frame Time: 'Frame Time:' expected, not '" + kRest + "'"));
  for (const char* time : {"0", "-0.01", "1e-9"}) {
    EXPECT_THAT(with("0.01", time), HasSubstr(":37: Frame Time: "));
  }
  EXPECT_EQ(with("0.01", "nan"), at(37, "Frame Time: must be a number, not 'nan'"));
  EXPECT_EQ(with("0  0 0 0\n", "0  0 0\n"),
            at(38, "MOTION: the row has 17 numbers, but the skeleton has 18 channels"));
  EXPECT_EQ(with("0  0 0 0\n", "0  0 0 0 0\n"),
            at(38, "MOTION: the row has 19 numbers, but the skeleton has 18 channels"));
  EXPECT_EQ(with("0  0 0 0\n", "0  0 0 NaN\n"), at(38, "MOTION: must be a number, not 'NaN'"));
  EXPECT_EQ(with("0  0 0 0\n", "0  0 0 1e999\n"), at(38, "MOTION: must be a number, not '1e999'"));
  const std::string no_rows = good.substr(0, good.find(kRest));
  EXPECT_EQ(error_of(write(no_rows, "x.bvh"), kSkeleton), at(37, "MOTION: the file has no frames"));
  EXPECT_EQ(error_of(write(no_rows + kRest + "\n" + kRest.substr(0, 30), "x.bvh"), kSkeleton)
                .substr(0, 16),
            "x.bvh:39: MOTION");
  std::string deep = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\n";
  for (int k = 0; k < 5000; ++k) deep += fmt::format("JOINT j{}\n{{\nOFFSET 0 1 0\n", k);
  EXPECT_EQ(error_of(write(deep, "x.bvh"), kSkeleton),
            at(6002, "j1999: the skeleton has more than 2000 joints"));
}

/// A right hand alone, in centimetres, as gloves export it: 19 cm from the wrist to the tip of the
/// middle finger.
std::string hand_alone() {
  const std::string channels = "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  std::string text = "HIERARCHY\nROOT RightHand\n{\nOFFSET 0 0 0\n" + channels;
  std::string row = "0 0 0";
  const auto add_finger = [&](const std::string& name, double across, double first, double bone) {
    for (int joint = 1; joint <= 3; ++joint) {
      text += fmt::format("JOINT RightHand{}{}\n{{\nOFFSET {} 0 {}\n{}", name, joint,
                          joint == 1 ? across : 0, joint == 1 ? first : bone, channels);
      row += " 0 0 0";
    }
    text += fmt::format("End Site\n{{\nOFFSET 0 0 {}\n}}\n}}\n}}\n}}\n", bone);
  };
  add_finger("Thumb", -4, 3, 3);
  add_finger("Index", -2.5, 9, 3);
  add_finger("Middle", 0, 9.4, 3.2);
  add_finger("Ring", 2, 9, 3);
  add_finger("Pinky", 4, 8, 2.5);
  return text + "}\nMOTION\nFrames: 2\nFrame Time: 0.01\n" + row + "\n" + row + "\n";
}

TEST_F(Bvh, AHandAloneIsAskedAboutAndThenRead) {
  const std::filesystem::path file = write(hand_alone(), "hand.bvh");
  ImportRequest request;
  request.paths = {file};
  try {
    read(request);
    ADD_FAILURE() << "not asked";
  } catch (const UnresolvedImport& question) {
    EXPECT_FALSE(question.names_unresolved);
    EXPECT_EQ(question.proposal.names.size(), 21u);
    ASSERT_EQ(question.proposal.conventions.size(), 2u);
    EXPECT_EQ(question.proposal.conventions[0].first, "unit");
    EXPECT_EQ(question.proposal.conventions[0].second.value, "cm");
    EXPECT_EQ(question.proposal.conventions[1].first, "axes");
    std::string names;
    for (const auto& [recorded, ours] : question.proposal.names)
      names += recorded + ": " + ours + "\n";
    request.name_map = write(names, "names.yaml");
  }
  request.conventions.unit = "cm";
  request.conventions.axes = "-x z y";
  const Demonstration hand = read(request);
  const BodyStream& skeleton = *hand.streams.skeleton;
  const Vec3 tip = skeleton.position(0, joint_of(skeleton, "right_middle_tip"));
  EXPECT_NEAR((tip - skeleton.position(0, joint_of(skeleton, "right_wrist"))).norm(), 0.19, 1e-9);
}

TEST_F(Bvh, ReadsOrRefusesWhateverIsCutOffOrChanged) {
  const std::string good = body("ZXY", {kRest, kRest});
  for (std::size_t length = 0; length < good.size(); length += 23) {
    error_of(write(good.substr(0, length), "x.bvh"), kSkeleton);
  }
  for (std::size_t at = 0; at < good.size(); at += 13) {
    for (const char byte : {'\0', '{', '}', '-', '\xff', '\n', '9'}) {
      std::string changed = good;
      changed[at] = byte;
      error_of(write(changed, "x.bvh"), kSkeleton);
    }
  }
}

}  // namespace
}  // namespace morphe::imports
