// Every mistake in a URDF, its SRDF or its description is one line: file, line and key.
#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"
#include "tests/core/robot/files/written_urdf.hpp"

namespace morphe::robot {
namespace {

struct Fault {
  std::string what, from, to, message;
};
class UrdfError : public testing::TestWithParam<Fault> {};

TEST_P(UrdfError, NamesFileLineAndKey) {
  const Fault& fault = GetParam();
  std::string texts[] = {kUrdf, kSrdf, kDescription};
  const char* names[] = {"two.urdf", "two.srdf", "two.yaml"};
  std::string expected;
  for (int i = 2; i >= 0; --i) {
    const std::size_t at = expected.empty() ? texts[i].find(fault.from) : std::string::npos;
    if (at != std::string::npos) texts[i].replace(at, fault.from.size(), fault.to);
    if (at != std::string::npos) expected = "changed";
    write_text(names[i], texts[i]);
  }
  ASSERT_EQ(expected, "changed");
  try {
    load_robot(robot_folder() / "two.yaml");
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    const std::string text = error.what();  // others may follow from it
    std::string message = (robot_folder() / fault.message).string();
    if (const std::size_t at = message.find("FOLDER"); at != message.npos)
      message.replace(at, 6, robot_folder().string());
    EXPECT_EQ(text.substr(0, text.find('\n')), message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, UrdfError,
    testing::Values(
        Fault{"missing_link", "<link name=\"tool\"/>", "",
              "two.urdf:18: joint plate.child: there is no link 'tool'"},
        Fault{"missing_parent", "<parent link=\"upper\"/>", "<parent link=\"uper\"/>",
              "two.urdf:22: joint b.parent: there is no link 'uper'"},
        Fault{"no_child", "<child link=\"upper\"/>", "", "two.urdf:6: joint a.child: is missing"},
        Fault{"loop", "<parent link=\"upper\"/>", "<parent link=\"tool\"/>",
              "two.urdf:16: joint plate: is part of a closed loop of joints"},
        Fault{"two_parents", "<child link=\"other\"/>", "<child link=\"finger\"/>",
              "two.urdf:38: joint d.child: link 'finger' is already the child of joint 'c'"},
        Fault{"two_roots", "<link name=\"finger\"/>", "<link name=\"finger\"/><link name=\"far\"/>",
              "two.urdf:45: link far: is a second root besides 'stand'; a URDF must have one root "
              "link"},
        Fault{"zero_axis", "0 2 0", "0 0 0", "two.urdf:10: joint a.axis: must not be zero"},
        Fault{"no_number", "0 2 0", "0 two 0",
              "two.urdf:10: joint a.axis.xyz: must be 3 numbers, not '0 two 0'"},
        Fault{"infinite_shape", "radius=\"0.06\"", "radius=\"inf\"",
              "two.urdf:28: link lower.sphere.radius: must be a number, not 'inf'"},
        Fault{"no_velocity", " velocity=\"2\"", "",
              "two.yaml:3: urdf: joint 'a' needs a velocity above 0: give it in the URDF, for all "
              "joints "
              "in urdf.velocity or for this one in urdf.limits"},
        Fault{"crossed_limits", "lower=\"-1\"", "lower=\"1.5\"",
              "two.urdf:11: joint a.limit.upper: must be above lower"},
        Fault{"no_limits", "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"2\"/>", "",
              "two.urdf:6: joint a.limit: is missing; add it to the URDF or give `lower` and "
              "`upper` in "
              "urdf.limits"},
        Fault{"screwed", "\"continuous\"", "\"screw\"",
              "two.urdf:21: joint b.type: must be revolute, continuous, prismatic or fixed, not "
              "'screw'"},
        Fault{"xacro", "0 2 0", "0 ${pi} 0",
              "two.urdf:10: axis: is a xacro file; convert it first: `xacro FOLDER/two.urdf "
              "> two_expanded.urdf`"},
        Fault{"coupled_to_itself", "joint=\"a\" multiplier", "joint=\"c\" multiplier",
              "two.urdf:30: joint c.mimic: is coupled to itself (mimic loop)"},
        Fault{"coupled_to_nothing", "joint=\"a\" multiplier", "joint=\"z\" multiplier",
              "two.urdf:30: joint c.mimic: there is no joint 'z' to mimic"},
        Fault{"joint_twice", "joint name=\"b\"", "joint name=\"a\"",
              "two.urdf:21: joint a: appears twice"},
        Fault{"no_xml", "</robot>\n", "<robot>\n",
              "two.srdf:3: not valid XML: an element is not closed"},
        Fault{"wrong_end", "</robot>\n", "</robots>\n",
              "two.srdf:1: not valid XML: an element is closed by the end tag of another"},
        Fault{"wrong_attribute", "link1=\"stand\"", "link1=stand",
              "two.srdf:2: not valid XML: an attribute cannot be read"},
        Fault{
            "no_jerk", "  jerk: 50\n", "",
            "two.yaml:3: urdf: joint 'a' needs a jerk above 0: give it in the URDF, for all joints "
            "in urdf.jerk or for this one in urdf.limits"},
        Fault{"limits_of_nothing", "joint: b", "joint: plate",
              "two.yaml:8: urdf.limits[0].joint: there is no joint 'plate' that moves"},
        Fault{"tip_on_nothing", "frame: finger", "frame: fingre",
              "two.yaml:13: tips[0].frame: there is no frame, link or chain 'fingre'"},
        Fault{"chain_backwards", "first: a, last: tool", "first: tool, last: a",
              "two.yaml:10: chains[0].last: must be a descendant of first"}),
    [](const auto& instance) { return instance.param.what; });

TEST(UrdfErrors, TheUnchangedFilesLoad) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  EXPECT_EQ(written_robot("two", kDescription).joints(), 2u);
}

}  // namespace
}  // namespace morphe::robot
