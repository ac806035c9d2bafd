// Pairs that one joint moves and that can never touch, on a bar that hangs from a crank and stays
// upright: its lower end is 0.2 (1 - cos a) nearer to the base at the angle a than at 0.
#include <gmock/gmock.h>

#include <cmath>

#include "core/robot/files/description.hpp"
#include "pipeline/setup/clear_covers.hpp"
#include "pipeline/setup/find_allowed_links.hpp"

namespace morphe::setup {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kCrank_m = 0.2, kRestGap_m = 0.025;

SceneObject box(const Vec3& centre, const Vec3& size) {
  SceneObject object;
  object.shape = Shape::box;
  object.size = {size.x(), size.y(), size.z()};
  object.position = {centre};
  object.orientation = {Quat::Identity()};
  return object;
}

RobotModel::Frame turning(const std::string& name, int parent, double height_m, int joint,
                          double ratio) {
  RobotModel::Frame frame;
  frame.name = name;
  frame.parent = parent;
  frame.transform.translation() = Vec3(0, 0, height_m);
  frame.axis = Vec3::UnitY();
  frame.joint = joint;
  frame.ratio = ratio;
  return frame;
}

/// A base, a crank on it and a bar on the crank, turned back by the crank's joint, or freely by a
/// second joint.
RobotModel crank_and_bar(double limit, bool coupled = true) {
  RobotModel robot;
  robot.frames = {turning("crank", -1, 0.1, 0, 1),
                  coupled ? turning("bar", 0, kCrank_m, 0, -1) : turning("bar", 0, kCrank_m, 1, 1)};
  const int joints = coupled ? 1 : 2;
  robot.joint_names = {"crank_joint"};
  if (!coupled) robot.joint_names.push_back("bar_joint");
  robot.lower = JointVector::Constant(joints, -limit);
  robot.upper = JointVector::Constant(joints, limit);
  robot.capsules = {{"base_1", -1, Vec3::Zero(), Vec3::UnitX() * 0.01, 0.05, false},
                    {"crank_1", 0, Vec3::Zero(), Vec3::UnitZ() * 0.2, 0.01, false},
                    {"bar_1", 1, Vec3::Zero(), Vec3::UnitZ() * -0.2, 0.02, false}};
  robot.allowed_collision_pairs = {{0, 1}, {1, 2}};
  return robot;
}

/// Judges the base, whose top is at 0.05 m, and the bar, whose lower end is at 0.075 m at rest.
std::vector<LinkPair> judged(const RobotModel& robot, bool with_bar = true) {
  std::map<int, std::vector<SceneObject>> shapes = {{-1, {box({0, 0, 0}, {0.6, 0.2, 0.1})}}};
  if (with_bar) shapes[1] = {box({0, 0, -0.12}, {0.04, 0.04, 0.21})};
  return judge_pairs(robot, link_bodies(shapes, robot));
}

std::string name_of(int frame) { return frame < 0 ? "base" : frame == 0 ? "crank" : "bar"; }

TEST(NeverTouch, OneJointAndShapesThatStayApartAreExcusedWithTheirLeastDistance) {
  const std::vector<LinkPair> pairs = judged(crank_and_bar(0.5));
  ASSERT_EQ(pairs.size(), 1u);
  const double least_m = kRestGap_m - kCrank_m * (1 - std::cos(0.5));  // 0.52 mm, at both limits
  EXPECT_TRUE(pairs[0].excused);
  EXPECT_TRUE(pairs[0].proven);
  EXPECT_NEAR(pairs[0].rest_gap_m, kRestGap_m, 1e-9);
  EXPECT_LE(pairs[0].least_gap_m, least_m + 1e-9);
  EXPECT_GE(pairs[0].least_gap_m, 0.98 * least_m);
  EXPECT_EQ(allowed_links_yaml(pairs, name_of),
            "  allowed_links:\n    - [base, bar]  # the shapes never touch: proved over the whole "
            "range of their joint, least distance " +
                least_distance_text(pairs[0]) + " mm\n");
  EXPECT_THAT(pairs_to_check(crank_and_bar(0.5), pairs, name_of),
              ElementsAre(HasSubstr("1 pair, the nearest at least 0.50 mm apart: [base, bar]")));
}

TEST(NeverTouch, ATouchAtTheEndOfTheRangeKeepsThePairChecked) {
  const std::vector<LinkPair> pairs = judged(crank_and_bar(0.52));  // 1.4 mm deep at the limits
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_FALSE(pairs[0].excused);
  EXPECT_EQ(pairs[0].least_gap_m, 0);
}

TEST(NeverTouch, TwoFreeJointsAreNoProof) {
  // As far apart, because the bar swings by little; but a plan chooses how.
  const std::vector<LinkPair> pairs = judged(crank_and_bar(0.1, false));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_GT(pairs[0].rest_gap_m, 0.02);
  EXPECT_FALSE(pairs[0].excused);
}

TEST(NeverTouch, AssumedShapesAreNoProof) {
  const std::vector<LinkPair> pairs = judged(crank_and_bar(0.1), false);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].assumed);
  EXPECT_GT(pairs[0].rest_gap_m, 0.02);
  EXPECT_FALSE(pairs[0].excused);
}

}  // namespace
}  // namespace morphe::setup
