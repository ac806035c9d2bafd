// The shipped BVH files against forward kinematics written in Python with numpy, independently of
// this code: 4x4 matrices along the channels as the file lists them, the root's and first joint's
// world as recorded, -x z y turned so that the shoulders of the first frame lie along X.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/rotate_demonstration.hpp"
#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::imports {
namespace {

using testing::HasSubstr;

struct Expected {
  std::size_t row;
  const char* joint;
  Vec3 position, x_axis;
};

/// The expected numbers are those of a body whose shoulder line points to X in the first frame.
Demonstration facing_y_first(Demonstration d) {
  const BodyStream& body = *d.streams.skeleton;
  const auto at = [&](const char* name) {
    const auto found = std::find(body.names.begin(), body.names.end(), name);
    return body.position(0, static_cast<std::size_t>(found - body.names.begin()));
  };
  const Vec3 line = at("right_shoulder") - at("left_shoulder");
  rotate_about_vertical(d, -std::atan2(line.y(), line.x()));
  return d;
}

void expect_joints(const Demonstration& d, const std::vector<Expected>& expected) {
  const BodyStream& body = *d.streams.skeleton;
  for (const auto& [row, joint, position, x_axis] : expected) {
    const auto found = std::find(body.names.begin(), body.names.end(), joint);
    ASSERT_NE(found, body.names.end()) << joint;
    const auto k = static_cast<std::size_t>(found - body.names.begin());
    EXPECT_LT((body.position(row, k) - position).norm(), 2e-6) << joint << " in row " << row;
    EXPECT_LT((body.orientation(row, k) * Vec3::UnitX() - x_axis).norm(), 3e-6)
        << joint << " in row " << row;
  }
}

TEST(BvhRecordings, IClone) {
  const auto all = shipped_recordings("cmu-iclone-bvh");
  ASSERT_EQ(all.size(), 2u);
  const BodyStream& scoop = *all[0].streams.skeleton;
  EXPECT_EQ(all[0].name, "cmu_002_06");
  EXPECT_EQ(scoop.names.size(), 141u);  // 100 joints and 41 End Sites
  ASSERT_EQ(scoop.time.size(), 1118u);
  EXPECT_NEAR(scoop.time.back(), 1117 * 0.016667, 1e-9);
  expect_joints(
      facing_y_first(all[0]),
      {{0, "right_elbow", {0.169697, -0.097691, 0.283725}, {0.877926, 0.426700, 0.217191}},
       {0, "right_index_dip", {0.227188, 0.147075, -0.038924}, {0.876207, 0.173840, 0.449489}},
       {0, "left_wrist", {-0.181609, 0.004031, 0.025115}, {0.942379, 0.084699, -0.323649}},
       {400, "right_wrist", {-0.179619, 0.553758, -0.845003}, {0.168633, 0.502283, 0.848100}},
       {400, "CC_Base_Head", {-0.137812, 0.366414, -0.330249}, {-0.792880, -0.602270, 0.092804}},
       {1117, "right_wrist", {0.291900, -0.092994, 0.028011}, {0.875841, -0.216762, 0.431181}},
       {1117,
        "right_index_tip",
        {0.379481, 0.045607, -0.037396},
        {0.878514, -0.204412, 0.431774}}});
  ASSERT_EQ(all[1].streams.skeleton->time.size(), 273u);
  expect_joints(
      facing_y_first(all[1]),
      {{0, "right_wrist", {0.564533, -0.088971, 0.287984}, {-0.329850, -0.565996, -0.755545}},
       {136, "right_elbow", {0.265547, 0.676305, 0.363390}, {0.740018, -0.547309, 0.390930}},
       {272, "right_little_pip", {0.109265, 0.554217, -0.092272}, {0.762620, 0.437776, 0.476197}}});
}

TEST(BvhRecordings, NativeCmu) {
  const auto all = shipped_recordings("cmu-native");
  ASSERT_EQ(all.size(), 1u);
  const BodyStream& walk = *all[0].streams.skeleton;
  EXPECT_EQ(walk.names.size(), 38u);  // 31 joints and 7 End Sites
  ASSERT_EQ(walk.time.size(), 523u);  // of 524; the first is a T-pose
  EXPECT_NEAR(walk.time.front(), 0.0083333, 1e-12);
  EXPECT_NEAR(walk.time.back(), 523 * 0.0083333, 1e-9);
  EXPECT_THAT(all[0].import_notes, testing::Contains(HasSubstr("mixed line endings")));
  EXPECT_THAT(all[0].import_notes, testing::Contains(HasSubstr("first frame skipped")));
  expect_joints(
      facing_y_first(all[0]),
      {{0, "right_elbow", {0.298520, -1.462524, 0.877481}, {-0.070272, -0.401181, 0.913299}},
       {0, "LeftFoot", {0.039421, -1.532469, 0.082018}, {-0.904953, 0.007595, -0.425443}},
       {261, "right_wrist", {0.243199, 0.648067, 0.737905}, {-0.046944, -0.584067, 0.810347}},
       {522, "right_wrist", {0.117307, 2.463485, 0.707814}, {-0.087932, -0.370231, 0.924769}},
       {522, "Head_end", {-0.106412, 2.420901, 1.407184}, {-0.951808, 0.274917, 0.135952}}});
}

// Four orders of rotation among its joints; the axes are given.
TEST(BvhRecordings, FiveFingers) {
  const auto all = shipped_recordings("pybvh");
  ASSERT_EQ(all.size(), 1u);
  const BodyStream& body = *all[0].streams.skeleton;
  EXPECT_EQ(body.names.size(), 73u);
  ASSERT_EQ(body.time.size(), 100u);
  EXPECT_NEAR(body.time.back(), 99 * 0.008333, 1e-9);
  EXPECT_TRUE(all[0].import_notes.empty());
  expect_joints(
      all[0],
      {{0, "right_elbow", {0.260516, -0.060566, 1.069776}, {0.026028, -0.414162, 0.909831}},
       {0, "right_wrist", {0.254225, 0.039539, 0.849866}, {-0.164537, -0.410265, 0.897001}},
       {0, "right_little_tip", {0.242680, 0.022108, 0.712696}, {0.918901, 0.022207, 0.393863}},
       {99, "right_little_tip", {0.248130, 0.005950, 0.712007}, {0.913181, 0.005349, 0.407518}},
       {99, "left_thumb_tip", {-0.113635, 0.091697, 0.754242}, {-0.110556, 0.268693, -0.956860}}});
}

}  // namespace
}  // namespace morphe::imports
