// What `morphe robot` says and draws, against a robot small enough to know by heart.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "pipeline/describe/robot_svg.hpp"
#include "pipeline/describe/robot_text.hpp"
#include "pipeline/describe/self_collision.hpp"
#include "pipeline/describe/svg_labels.hpp"

namespace morphe::describe {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two links of 0.3 and 0.2 m along z, bent about x; a finger of one coupled joint beside them.
robot::RobotDescription two_links() {
  robot::RobotDescription description;
  RobotModel& robot = description.table;
  robot.name = "two <links>";
  robot.joint_names = {"a", "b"};
  robot.lower = JointVector::Constant(2, -1);
  robot.upper = (JointVector(2) << 2, 0.25).finished();
  robot.velocity = robot.acceleration = robot.jerk = JointVector::Ones(2);
  const auto up = [](double z) { return make_pose({0, 0, z}, Quat::Identity()); };
  robot.frames = {{"a", -1, up(0.1), Vec3::UnitX(), 0},
                  {"b", 0, up(0.3), Vec3::UnitX(), 1},
                  {"c", 1, up(0), Vec3::UnitY(), 1, 2, 0.5},
                  {"palm", 1, up(0.15), Vec3::UnitZ(), -1}};
  robot.tips = {{"end", 3, up(0.05), -1}, {"pad", 2, up(0.02), 2, 0.5}};
  robot.joint_centres = {{1, "arm"}};
  robot.capsules = {{"link", 0, {0, 0, 0}, {0, 0, 0.3}, 0.02, false}};
  robot.shoulder_frame = 0;
  robot.palm_frame = 3;
  return description;
}

TEST(RobotReport, ReachIsThatOfTheStretchedLinks) {
  const RobotModel robot = two_links().table;
  EXPECT_NEAR(stretched_reach(robot, robot.tips[0]), 0.3 + 0.15 + 0.05, 1e-15);
  EXPECT_NEAR(stretched_reach(robot, robot.tips[1]), 0.3 + 0.02, 1e-15);
}

TEST(RobotReport, RemarksOnWhatIsHardlyMeant) {
  robot::RobotDescription robot = two_links();
  robot.notes = {"hand.urdf:7: a mesh"};
  EXPECT_THAT(plausibility_notes(robot),
              ElementsAre("hand.urdf:7: a mesh",
                          "tip pad has no joint centre for the humanlikeness of its finger"));
  robot.table.tips[1].frame = 0;  // the palm moves with b, this one before it
  EXPECT_THAT(plausibility_notes(robot), testing::Contains("tip pad is not on the palm palm"));
  robot.notes.clear();
  robot.table.unchecked_links = {"upper", "hand"};
  robot.table.tips.pop_back();
  robot.table.tips[0].frame = 0;
  robot.table.palm_frame = 0;
  robot.table.shoulder_frame = 1;
  EXPECT_THAT(plausibility_notes(robot),
              ElementsAre("joint b moves no tip", "palm a is not moved by the shoulder b",
                          "collisions of upper, hand are not checked: no collision shape given"));
}

TEST(RobotReport, PrintsJointsCouplingsAndTips) {
  const std::string text = robot_text(two_links());
  EXPECT_THAT(text, HasSubstr("two <links>: joints 2, coupled 1, tips 2, capsules 1; shoulder a, "
                              "palm palm, reach 0.500 m\n"));
  EXPECT_THAT(text, HasSubstr("\na              -57.3    114.6        1        1        1\n"));
  EXPECT_THAT(text, HasSubstr("\nc           2 x b + 28.65 deg\n"));
  EXPECT_THAT(text, HasSubstr("\npad         c              0.320  50 % from index to little\n"));
  EXPECT_THAT(
      text, HasSubstr("\nnote: tip pad has no joint centre for the humanlikeness of its finger\n"));
}

/// The number behind the first `before` from `at` on; moves `at` behind it.
double number_behind(const std::string& svg, const std::string& before, std::size_t& at) {
  at = svg.find(before, at);
  if (at == std::string::npos) return kUnknown;
  at += before.size();
  return std::stod(svg.substr(at));
}

/// Centres of the circles of one colour, in the order drawn.
std::vector<std::pair<double, double>> dots(const std::string& svg, const std::string& colour) {
  std::vector<std::pair<double, double>> found;
  for (std::size_t at = 0;;) {
    const double x = number_behind(svg, "<circle cx=\"", at);
    if (at == std::string::npos) return found;
    const double y = number_behind(svg, "cy=\"", at);
    const std::string circle = svg.substr(at, svg.find("/>", at) - at);
    if (circle.find("fill=\"" + colour) != std::string::npos) found.emplace_back(x, y);
  }
}

TEST(RobotDrawing, TipsStandWhereTheyAreToScale) {
  robot::RobotDescription robot = two_links();
  const auto scale_of = [](const std::string& svg) {
    std::size_t bar = svg.rfind("<path d=\"M");
    return 10 * number_behind(svg, "h", bar += 10);
  };
  std::string svg = robot_svg(robot.table);
  auto tips = dots(svg, "#c0392b"), joints = dots(svg, "#1f5fa8");
  ASSERT_EQ(tips.size(), 4u);  // two tips, two views
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_EQ(dots(svg, "#2e7d4f").size(), 2u);  // the finger's
  // At zero the end stands 0.5 m above joint a, in both views.
  for (const std::size_t view : {0u, 1u}) {
    EXPECT_NEAR(joints[2 * view].second - tips[2 * view].second, 0.5 * scale_of(svg), 0.1);
    EXPECT_NEAR(tips[2 * view].first, joints[2 * view].first, 0.02);
  }
  EXPECT_THAT(svg, HasSubstr("two &lt;links&gt;: 2 joints"));
  EXPECT_EQ(svg, robot_svg(robot.table));
  // Bent about x, as the limits want it: to the left of y.
  const double a = std::numbers::pi / 6, b = a + 0.25;
  robot.table.lower = (JointVector(2) << a, 0.25).finished();
  svg = robot_svg(robot.table);
  tips = dots(svg, "#c0392b");
  joints = dots(svg, "#1f5fa8");
  EXPECT_NEAR(tips[0].first - joints[0].first,
              -scale_of(svg) * (0.3 * std::sin(a) + 0.2 * std::sin(b)), 0.1);
  EXPECT_NEAR(joints[0].second - tips[0].second,
              scale_of(svg) * (0.3 * std::cos(a) + 0.2 * std::cos(b)), 0.1);
  EXPECT_NEAR(tips[2].first, joints[2].first, 0.02);  // from the side it stays on x = 0
}

TEST(RobotDrawing, StaysInsideItsPanels) {
  const std::string svg = robot_svg(two_links().table);
  std::size_t index = 0, header = 0;
  const double height = number_behind(svg, " height=\"", header);
  for (const auto& [x, y] : dots(svg, "#1f5fa8")) {
    const bool right = index++ / 2 == 1;
    EXPECT_GT(x, right ? 620 + kLabelColumn_px : kLabelColumn_px);
    EXPECT_LT(x, right ? 1240 - kLabelColumn_px : 620 - kLabelColumn_px);
    EXPECT_GT(y, 66);
    EXPECT_LT(y, height - 46);
  }
}

TEST(RobotDrawing, LabelsOfOnePlaceDoNotOverlap) {
  std::vector<SvgLabel> labels;
  for (int k = 0; k < 50; ++k)
    labels.push_back({400, 90.0 + k % 3, fmt::format("joint{}", k), "#000"});
  SvgPanel panel{0, 20, 600, 0};
  panel.height = height_for_labels(labels, panel);
  const std::string svg = labels_svg(labels, panel);
  double before = panel.top;
  std::size_t count = 0;
  for (std::size_t at = 0; (at = svg.find("<text ", at)) != std::string::npos; ++count) {
    EXPECT_NEAR(number_behind(svg, "x=\"", at), 600 - kLabelColumn_px, 0.1);
    const double y = number_behind(svg, "y=\"", at);
    EXPECT_GE(y - before, kLabelFontSize_px);
    before = y;
  }
  EXPECT_EQ(count, labels.size());
  EXPECT_LE(before, panel.top + panel.height);
}

/// A base, and an arm that can turn its end into the base; a collar that always touches the end.
RobotModel turning() {
  RobotModel robot = two_links().table;
  robot.lower = JointVector::Constant(2, -std::numbers::pi);
  robot.upper = -robot.lower;
  // Capsules 1 and 2 lie on bodies with a joint between, 3 far above everything.
  robot.capsules = {{"base", -1, {0, 0, 0}, {0, 0, 0.02}, 0.06, false},
                    {"end", 1, {0, 0, 0.05}, {0, 0, 0.15}, 0.02, false},
                    {"collar", 0, {0, 0, 0.29}, {0, 0, 0.31}, 0.06, false},
                    {"lamp", -1, {0, 0, 2}, {0, 0, 2.1}, 0.02, false}};
  return robot;
}

TEST(SelfCollision, TellsAlwaysFromNeverFromSometimes) {
  const RobotModel robot = turning();
  const SelfCollision found = sample_self_collision(robot, 4000);
  const auto pairs = [](const std::vector<SelfCollisionPair>& list) {
    std::vector<std::array<int, 2>> capsules;
    for (const SelfCollisionPair& pair : list) capsules.push_back(pair.capsules);
    return capsules;
  };
  // Base and lamp do not move against each other: no pair.
  EXPECT_THAT(pairs(found.always), ElementsAre(std::array{1, 2}));
  EXPECT_THAT(pairs(found.never),
              ElementsAre(std::array{0, 2}, std::array{1, 3}, std::array{2, 3}));
  EXPECT_THAT(pairs(found.sometimes), ElementsAre(std::array{0, 1}));
  // The lamp's end at 1.98 m is beyond the stretched arm's, 0.1 + 0.3 + 0.15 + 0.02.
  EXPECT_GE(found.never[1].distance_m, 1.98 - 0.57);
  const std::string text = self_collision_text(robot, found);
  EXPECT_THAT(text, HasSubstr("5 pairs of capsules in 4000 positions: 1 always overlap, 3 never"));
  EXPECT_THAT(text, HasSubstr("  - [end, collar]\n"));
  EXPECT_EQ(text, self_collision_text(robot, sample_self_collision(robot, 4000)));
  EXPECT_THAT(self_collision_json(robot, found), HasSubstr("\"samples\": 4000"));
}

}  // namespace
}  // namespace morphe::describe
