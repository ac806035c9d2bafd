// Limits that a URDF lacks, locks, or gives in another unit: held, asked for, or assumed and said.
#include <gmock/gmock.h>

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "tests/pipeline/setup/primitive_hands.hpp"

namespace morphe::setup {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// An arm of seven joints, of which the sixth has this element of limits.
std::string arm_with(const std::string& limits, const std::string& type = "revolute") {
  std::vector<Part> parts;
  for (int k = 1; k <= 7; ++k) {
    parts.push_back({fmt::format("l{}", k), k == 1 ? "base" : fmt::format("l{}", k - 1), "0 0 0.15",
                     k % 2 == 1 ? "0 0 1" : "0 1 0", k == 6 ? limits : limit(-2, 2)});
    if (k == 6) parts.back().type = type;
  }
  return urdf_of_parts("base", parts);
}

TEST(Limits, EqualOnesLockAJoint) {
  const MadeHand made = set_up_parts(arm_with(limit(0, 0, 0)));
  EXPECT_EQ(made.table().joints(), 6u);
  EXPECT_THAT(made.table().joint_names, Not(Contains("l6_j")));
  EXPECT_THAT(made.result.to_check,
              Contains(AllOf(HasSubstr("l6_j: locked by the URDF"), HasSubstr("--limit"))));
  SetupRequest request;
  request.limits["l6_j"] = {-1, 1.5};
  const MadeHand freed = set_up_parts(arm_with(limit(0, 0, 0)), request);
  ASSERT_EQ(freed.table().joints(), 7u);
  EXPECT_EQ(freed.table().lower[5], -1);
  EXPECT_EQ(freed.table().upper[5], 1.5);
}

TEST(Limits, BothAbsentAreAssumedAndSaid) {
  const MadeHand made = set_up_parts(arm_with("<limit velocity=\"2\" effort=\"1\"/>"));
  ASSERT_EQ(made.table().joints(), 7u);
  EXPECT_NEAR(made.table().upper[5], 3.14159, 1e-4);
  EXPECT_THAT(made.result.to_check,
              Contains(HasSubstr("l6_j (-3.14 to 3.14 rad): limits of position "
                                 "that the URDF lacks are assumed")));
  // One of them alone: the other is 0, as the format says.
  EXPECT_EQ(
      set_up_parts(arm_with("<limit upper=\"2\" velocity=\"2\" effort=\"1\"/>")).table().lower[5],
      0);
}

TEST(Limits, DegreesAndMillimetresAreAskedFor) {
  EXPECT_THAT(
      [] { set_up_parts(arm_with(limit(-130, 130, 180))); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("joint l6_j.limit: -130 to 130 rad are degrees"),
                                      HasSubstr("--limit l6_j=-2.269..2.269"))));
  EXPECT_THAT([] { set_up_parts(arm_with(limit(0, 40), "prismatic")); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("millimetres"), HasSubstr("--limit l6_j=0..0.04"))));
  EXPECT_EQ(set_up_parts(arm_with(limit(-7, 7))).table().upper[5], 7);  // a wrist of 400 degrees
  SetupRequest request;
  request.limits["l6_j"] = {-2.269, 2.269};
  EXPECT_EQ(set_up_parts(arm_with(limit(-130, 130, 2)), request).table().upper[5], 2.269);
}

TEST(Limits, ThoseWithoutEndsAreOfAContinuousJoint) {
  const MadeHand made = set_up_parts(arm_with(limit(-1e16, 1e16)));
  EXPECT_NEAR(made.table().upper[5], 2 * 3.14159265, 1e-6);
  EXPECT_THAT(made.result.notes,
              Contains(HasSubstr("joint l6_j: -1e+16 to 1e+16 rad are no limits")));
}

TEST(Limits, VelocitiesOfZeroOrWithoutLoadAreAssumedAndSaid) {
  const MadeHand zero = set_up_parts(arm_with(limit(-2, 2, 0)));
  EXPECT_EQ(zero.table().velocity[5], 1);
  EXPECT_THAT(zero.result.to_check,
              Contains(HasSubstr("l6_j (1 rad/s): velocities that are 0 or missing")));
  const MadeHand motor = set_up_parts(arm_with(limit(-2, 2, 37)));
  EXPECT_EQ(motor.table().velocity[5], 3.14);
  EXPECT_NEAR(motor.table().acceleration[5], 9.42, 1e-9);
  EXPECT_THAT(motor.result.to_check, Contains(HasSubstr("l6_j (3.14 instead of 37 rad/s)")));
}

TEST(Limits, OfACoupledJointThatAreBothZeroDoNotHoldItsDriver) {
  std::string text = arm_with(limit(-1, 1));
  text.replace(text.find("</robot>"), 8, "");
  text +=
      "<link name=\"c\"/><joint name=\"c_j\" type=\"revolute\"><parent link=\"l7\"/><child "
      "link=\"c\"/>"
      "<limit lower=\"0\" upper=\"0\" velocity=\"0\" effort=\"0\"/><mimic "
      "joint=\"l6_j\"/></joint></robot>";
  const RobotModel table = set_up_parts(text).table();
  const auto driver = std::ranges::find(table.joint_names, "l6_j") - table.joint_names.begin();
  ASSERT_LT(driver, std::ssize(table.joint_names));
  EXPECT_EQ(table.upper[driver], 1);
}

TEST(Limits, AnUnknownJointIsRefused) {
  SetupRequest request;
  request.limits["l9_j"] = {0, 1};
  EXPECT_THAT([&] { set_up_parts(arm_with(limit(-1, 1)), request); },
              ThrowsMessage<InputError>(HasSubstr("'l9_j', but there is no such joint")));
}

TEST(Checks, AreKeptWithTheRobotUntilSomebodyDeletesThem) {
  SetupRequest request;
  request.urdf = robot::write_text("made.urdf", arm_with(limit(0, 0, 0)));
  request.out = robot::robot_folder() / "made.yaml";
  request.budget = {1, 1, 1, 1, 1};
  const SetupResult made = make_description(request, std::nullopt);
  const robot::RobotDescription robot = robot::parse_robot(made.text, request.out);
  EXPECT_EQ(robot.checks, made.to_check);
  ASSERT_THAT(robot.checks, Contains(HasSubstr("l6_j: locked")));
  EXPECT_EQ(make_description(request, made.text).text, made.text);
  // A line that is done is deleted, and stays so.
  std::string edited = made.text;
  const std::size_t line = edited.find("  - 'l6_j: locked");
  edited.erase(line, edited.find('\n', line) + 1 - line);
  const SetupResult again = make_description(request, edited);
  EXPECT_THAT(again.to_check, Not(Contains(HasSubstr("l6_j: locked"))));
  EXPECT_EQ(again.to_check.size() + 1, made.to_check.size());
  EXPECT_THAT(again.notes, Contains("kept because edited: check"));
}

}  // namespace
}  // namespace morphe::setup
