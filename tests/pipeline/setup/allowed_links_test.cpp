// Which pairs of links are excused, on boxes whose distance in every posture is plain to see, and
// that a cover which is clear means shapes which are clear.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <regex>

#include "core/collision/distance.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/setup/find_allowed_links.hpp"
#include "pipeline/setup/setup.hpp"
#include "tests/core/robot/files/written_urdf.hpp"
#include "tests/core/robot/shipped_robots.hpp"
#include "tests/pipeline/setup/small_robots.hpp"

namespace morphe::setup {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

struct MadeBoxes {
  SetupResult result;
  RobotModel robot;
  LinkBodies bodies;
  std::vector<LinkPair> pairs;

  LinkPair pair(const std::string& one, const std::string& other) const {
    for (const LinkPair& p : pairs)
      if (name(p.first) == one && name(p.second) == other) return p;
    ADD_FAILURE() << one << " and " << other << " are not judged";
    return {};
  }
  std::string name(int frame) const { return robot.frames[static_cast<std::size_t>(frame)].name; }
};

/// Makes the description of a URDF, whose elbow may be given, and judges its pairs by the shapes of
/// the file.
MadeBoxes made_from(const std::string& urdf, const std::string& elbow = "") {
  SetupRequest request;
  request.urdf = robot::write_text("boxes.urdf", urdf);
  request.out = robot::robot_folder() / "boxes.yaml";
  request.elbow = elbow;
  MadeBoxes made;
  made.result = make_description(request, std::nullopt);
  made.robot = robot::parse_robot(made.result.text, request.out).table;
  const robot::UrdfModel model = robot::load_urdf_model(request.urdf);
  const LinkShapes shapes = read_shapes(kinematics_of(model), {});
  made.bodies = link_bodies(shapes.shapes_by_frame, made.robot);
  const std::string all_checked =
      std::regex_replace(made.result.text, std::regex("  allowed_links:\n(    - .*\n)*"), "");
  made.pairs = judge_pairs(robot::parse_robot(all_checked, request.out).table, made.bodies);
  return made;
}

/// A torso and an upper arm 15 mm beside it, with two links without shapes between them.
std::string fat_pair() {
  return chain_of_boxes("0.25 0.3 0.4",
                        {{"s1", "0 -0.2 0.15", "0 1 0", -2.5, 2.5, "", ""},
                         {"s2", "0 0 0", "1 0 0", -1.5, 0.6, "", ""},
                         {"s3", "0 0 0", "0 0 1", -2.5, 2.5, "0 0.005 -0.12", "0.06 0.06 0.2"},
                         {"e4", "0 0 -0.25", "0 1 0", -2, 0.2, "0 0 -0.06", "0.05 0.05 0.1"}});
}

/// Returns the number of pairs of bodies whose capsules are clear in a posture though their shapes
/// are not, in so many random postures. Neighbours and excused pairs are not asked.
int unsound_pairs(const MadeBoxes& made, int postures) {
  const RobotModel& robot = made.robot;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Pose> poses;
  int unsound = 0;
  for (int k = 0; k < postures; ++k) {
    JointVector q(robot.lower.size());
    for (Eigen::Index j = 0; j < q.size(); ++j)
      q[j] = robot.lower[j] + share(random) * (robot.upper[j] - robot.lower[j]);
    robot::forward_kinematics(robot, q, poses);
    for (const LinkPair& pair : made.pairs) {
      if (pair.excused) continue;
      const Pose &first = poses[static_cast<std::size_t>(pair.first)],
                 &second = poses[static_cast<std::size_t>(pair.second)];
      double distance_m = 1;
      for (const RobotModel::Capsule& a : robot.capsules) {
        for (const RobotModel::Capsule& b : robot.capsules) {
          if (a.frame != pair.first || b.frame != pair.second) continue;
          distance_m = std::min(
              distance_m, collision::capsule_capsule({first * a.from, first * a.to, a.radius},
                                                     {second * b.from, second * b.to, b.radius})
                              .distance);
        }
      }
      unsound += distance_m > 0.001 &&
                 made.bodies.at(pair.first)
                     .mesh.overlaps(made.bodies.at(pair.second).mesh, first.inverse() * second);
    }
  }
  return unsound;
}

const MadeBoxes& made_fat_pair() {
  static const MadeBoxes made = made_from(fat_pair());
  return made;
}

TEST(AllowedLinks, ShapesApartAtRestAreCheckedAndTheirCapsulesClear) {
  const MadeBoxes& made = made_fat_pair();
  const LinkPair pair = made.pair("base", "j_s3");
  EXPECT_NEAR(pair.rest_gap_m, 0.015, 1e-6);  // 0.2 - 0.15 - 0.03 - 0.005
  EXPECT_FALSE(pair.excused);
  EXPECT_THAT(made.result.text, Not(HasSubstr("allowed_links")));
  EXPECT_THAT(made.result.to_check, Not(Contains(HasSubstr("[base, s3]"))));
}

TEST(AllowedLinks, ClearCapsulesMeanClearShapes) {
  EXPECT_EQ(unsound_pairs(made_fat_pair(), 1000), 0);
}

TEST(AllowedLinks, BodiesThatOverlapInAllPosturesAreExcused) {
  // b stands 20 mm deep in the base, and a between them turns it about the upright.
  const MadeBoxes made = made_from(
      chain_of_boxes("0.2 0.2 0.1",
                     {{"a", "0 0 0.04", "0 0 1", -1, 1, "0.2 0 0.1", "0.02 0.02 0.02"},
                      {"b", "0 0 0", "1 0 0", -0.001, 0.001, "0 0 0.06", "0.04 0.04 0.14"},
                      {"c", "0 0 0.3", "0 1 0", -1, 1, "0 0 0", "0.03 0.03 0.03"}}),
      "j_b");
  const LinkPair pair = made.pair("base", "j_b");
  EXPECT_TRUE(pair.excused);
  EXPECT_NEAR(pair.rest_depth_m, 0.02, 0.002);  // from z = 0.03 to the base's top at 0.05
  EXPECT_THAT(made.result.text, HasSubstr("[base, b]  # the shapes overlap at rest by 20.0 mm"));
}

TEST(AllowedLinks, AnOverlapAtRestAloneExcusesNoPair) {
  // An arm folded at rest: its last link lies in the base, and leaves it when the elbow turns.
  const MadeBoxes made =
      made_from(chain_of_boxes("0.2 0.2 0.1",
                               {{"a", "0 0 0.2", "0 0 1", -1, 1, "0 0 0", "0.05 0.05 0.05"},
                                {"b", "0 0 0.1", "0 1 0", -2, 2, "0 0 0", "0.05 0.05 0.05"},
                                {"c", "0 0 0.1", "0 1 0", -2, 2, "0 0 -0.3", "0.04 0.04 0.2"}}),
                "j_c");
  const LinkPair pair = made.pair("base", "j_c");
  EXPECT_GT(pair.rest_depth_m, 0.01);
  EXPECT_FALSE(pair.excused);
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("[base, c]: the shapes overlap by")));
}

TEST(AllowedLinks, CapsulesWithoutShapesAreSaidToBeAssumed) {
  // b has no shape: a capsule of an assumed thickness stands for it.
  const MadeBoxes made = made_from(chain_of_boxes(
      "0.2 0.2 0.1", {{"a", "0 0 0.06", "0 0 1", -1, 1, "0 0 0.01", "0.05 0.05 0.02"},
                      {"b", "0 0 0", "0 1 0", -1, 1, "", ""},
                      {"c", "0 0 0.2", "0 1 0", -1, 1, "0 0 0.1", "0.04 0.04 0.1"}}));
  EXPECT_TRUE(made.pair("base", "j_b").assumed);
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("shapes of b are assumed")));
}

}  // namespace
}  // namespace morphe::setup
