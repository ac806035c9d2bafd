// Every mistake in a description is one line that names the file, the line and the key.
#include <gmock/gmock.h>

#include "core/motion/input_error.hpp"
#include "tests/core/robot/files/written_robot.hpp"

namespace morphe::robot {
namespace {

using testing::EndsWith;
using testing::ThrowsMessage;

struct Mistake {
  std::string what, from, to;  ///< the first `from` in the description becomes `to`
  std::string message;         ///< after the file's name
};

const std::string kTwoJoints = R"(name: two
convention: modified
chains:
  - name: arm
    joints:
      - name: a
        theta: 0
        d: 0
        a: 0
        alpha: 0
        lower: -1
        upper: 1
        velocity: 1
        acceleration: 1
        jerk: 1
      - {name: b, theta: 0, d: 0, a: 1, alpha: 0, couple: {joint: a, ratio: 1, offset: 0}}
frames:
  - {name: plate, parent: arm, mount: {position: [0, 0, 1], rpy: [0, 0, 0]}}
shoulder: a
palm: plate
tips:
  - {name: end, chain: arm, finger: wrist}
collision:
  capsules:
    - {name: link, frame: a, from: [0, 0, 0], to: [1, 0, 0], radius: 0.1}
    - {name: foot, frame: base, from: [0, 0, 0], to: [0, 0, 1], radius: 0.1}
  allowed_collision_pairs: [[link, foot]]
  may_touch_target: [link]
)";

class DescriptionError : public testing::TestWithParam<Mistake> {};

TEST_P(DescriptionError, NamesFileLineAndKey) {
  const Mistake& mistake = GetParam();
  std::string yaml = kTwoJoints;
  const std::size_t at = yaml.find(mistake.from);
  ASSERT_NE(at, std::string::npos);
  yaml.replace(at, mistake.from.size(), mistake.to);
  const std::filesystem::path file = write_robot("two", yaml);
  try {
    load_robot(file);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file.string() + mistake.message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, DescriptionError,
    testing::Values(
        Mistake{"no_limit", "        upper: 1\n", "", ":6: chains[0].joints[0].upper: is missing"},
        Mistake{"no_jerk", "        jerk: 1\n", "", ":6: chains[0].joints[0].jerk: is missing"},
        Mistake{"infinite_limit", "velocity: 1", "velocity: .inf",
                ":13: chains[0].joints[0].velocity: must be a number, not '.inf'"},
        Mistake{"no_room", "upper: 1", "upper: -1",
                ":12: chains[0].joints[0].upper: must be above lower"},
        Mistake{
            "no_speed", "velocity: 1", "velocity: 0",
            ":13: chains[0].joints[0].velocity: must be above 0 and at most 1e+06 rad/s, not 0"},
        Mistake{"unknown_key", "shoulder: a", "shouldr: a",
                ":19: shouldr: unknown key; did you mean 'shoulder'?"},
        Mistake{
            "limits_of_a_coupled_joint", "alpha: 0, couple", "alpha: 0, velocity: -1, couple",
            ":16: chains[0].joints[1].velocity: must be above 0 and at most 1e+06 rad/s, not -1"},
        Mistake{"unknown_coupled_joint", "joint: a", "joint: c",
                ":16: chains[0].joints[1].couple.joint: there is no actuated joint 'c' before this "
                "one"},
        Mistake{"coupled_to_itself", "joint: a", "joint: b",
                ":16: chains[0].joints[1].couple.joint: is the joint itself; name another joint"},
        Mistake{"frames_in_a_loop", "- {name: plate, parent: arm,",
                "- {name: rim, parent: plate}\n  - {name: plate, parent: rim,",
                ":18: frames[0].parent: is a loop: the frame is its own ancestor"},
        Mistake{"parent_of_the_chain", "name: arm\n", "name: arm\n    parent: plate\n",
                ":5: chains[0].parent: there is no frame, link or chain 'plate'"},
        Mistake{"tip_on_nothing", "{name: end, chain: arm,", "{name: end, frame: base,",
                ":22: tips[0].frame: a tip must be attached to a frame that moves"},
        Mistake{"joint_twice", "{name: b", "{name: a",
                ":16: chains[0].joints[1].name: a frame or chain 'a' already exists"},
        Mistake{"convention", "convention: modified", "convention: craig",
                ":2: convention: must be modified or standard, not 'craig'"},
        Mistake{"unknown_frame_in_capsule", "frame: a,", "frame: z,",
                ":25: collision.capsules[0].frame: there is no frame, link or chain 'z'"},
        Mistake{"flat_capsule", "radius: 0.1", "radius: 0",
                ":25: collision.capsules[0].radius: must be above 0 and at most 10 m, not 0"},
        Mistake{"capsule_twice", "name: foot", "name: link",
                ":26: collision.capsules[1].name: a capsule 'link' already exists"},
        Mistake{"unknown_capsule", "[[link, foot]]", "[[link, feet*]]",
                ":27: collision.allowed_collision_pairs[0][1]: there is no capsule 'feet*'"},
        Mistake{"unknown_touching_capsule", "target: [link]", "target: [hand]",
                ":28: collision.may_touch_target[0]: there is no capsule 'hand'"},
        Mistake{"unknown_parent", "parent: arm", "parent: leg",
                ":18: frames[0].parent: there is no frame, link or chain 'leg'"},
        Mistake{"two_rotations", "rpy: [0, 0, 0]", "rpy: [0, 0, 0], quaternion: [1, 0, 0, 0]",
                ":18: frames[0].mount: must have only one of rpy, quaternion and matrix"},
        Mistake{"mirror", "rpy: [0, 0, 0]", "matrix: [[1, 0, 0], [0, 1, 0], [0, 0, -1]]",
                ":18: frames[0].mount.matrix: must be a rotation matrix"},
        Mistake{"long_quaternion", "rpy: [0, 0, 0]", "quaternion: [1, 1, 0, 0]",
                ":18: frames[0].mount.quaternion: must have length 1"},
        Mistake{"unknown_palm", "palm: plate", "palm: hand",
                ":20: palm: there is no frame or link 'hand'"},
        Mistake{"unknown_tip_chain", "chain: arm", "chain: leg",
                ":22: tips[0].chain: there is no frame, link or chain 'leg'"},
        Mistake{
            "unknown_finger", "finger: wrist", "finger: toe",
            ":22: tips[0].finger: must be thumb, index, middle, ring, little, wrist or 0 … 4, not "
            "'toe'"}),
    [](const auto& instance) { return instance.param.what; });

struct BadGenerator {
  std::string yaml, message;
};

TEST(DescriptionErrors, OfGeneratedRobots) {
  for (const BadGenerator& bad : std::vector<BadGenerator>{
           {"{}", ":2: generate: must have either arm or hand"},
           {"{arm: {joints: 5, length: 1}}",
            ":2: generate.arm.joints: must be at least 6 and at most 60, not 5"},
           {"{arm: {joints: 6}}", ":2: generate.arm.length: is missing"},
           {"{arm: {joints: 6, length: 1, links: 2}}", ":2: generate.arm.links: unknown key"},
           {"{hand: {fingers: 2, length: 1, breadth: 1}}",
            ":2: generate.hand.fingers: must be at least 3 and at most 12, not 2"},
           {"{hand: {fingers: 4, length: 0, breadth: 1}}",
            ":2: generate.hand.length: must be above 0 and at most 10 m, not 0"}}) {
    const std::filesystem::path file = write_robot("g", "name: g\ngenerate: " + bad.yaml + "\n");
    try {
      load_robot(file);
      ADD_FAILURE() << bad.yaml;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), file.string() + bad.message);
    }
  }
}

TEST(DescriptionErrors, TwoGeneratedArms) {
  EXPECT_THAT(
      [] {
        written_robot("g",
                      "name: g\nparts:\n  - generate: {arm: {joints: 6, length: 1}}\n"
                      "  - generate: {arm: {joints: 6, length: 1}}\n");
      },
      ThrowsMessage<InputError>(EndsWith("g.yaml:4: parts[1].generate.arm: already exists")));
}

TEST(DescriptionErrors, TheUnchangedDescriptionLoads) {
  EXPECT_EQ(written_robot("two", kTwoJoints).joints(), 1u);
}

TEST(DescriptionErrors, OfAPartNameThePart) {
  write_robot("part", "name: part\nchains: []\n");
  const std::filesystem::path whole = write_robot("whole", "name: w\nparts: [{file: part.yaml}]\n");
  try {
    load_robot(whole);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("part.yaml:1: has no chains"));
  }
}

TEST(DescriptionErrors, AFileThatIsItsOwnPart) {
  EXPECT_THAT([] { written_robot("self", "name: s\nparts: [{file: self.yaml}]\n"); },
              ThrowsMessage<InputError>(EndsWith(
                  "self.yaml:2: parts[0].file: more than 32 files; does a file include itself?")));
}

TEST(DescriptionErrors, AFileThatIsNotThere) {
  EXPECT_THAT([] { load_robot(robot_folder() / "none.yaml"); },
              ThrowsMessage<InputError>(EndsWith("none.yaml: cannot be read")));
}

}  // namespace
}  // namespace morphe::robot
