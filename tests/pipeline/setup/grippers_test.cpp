// Grippers of the common forms, made of boxes: which parts are jaws, where their pads are and which
// way these face. The answers are the numbers in the URDFs.
#include <gmock/gmock.h>

#include <regex>

#include "core/motion/input_error.hpp"
#include "core/robot/opening.hpp"
#include "tests/pipeline/setup/primitive_hands.hpp"

namespace morphe::setup {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kPalmShape = box_shape("0 0 0.02", "0.03 0.1 0.04");

/// Two jaws that slide along y: 60 mm long from z = 0.05 on, 10 mm thick, with their inner faces on
/// their frames' planes y = 0 when closed.
struct Sliding {
  const char* name;
  double lower, upper;  ///< of the first jaw
  double sign;          ///< of the first jaw's axis along y
  double offset;        ///< y of the first jaw's frame, that of the second is the opposite
  bool coupled, shapes;
  double closed, open;  ///< positions of the first jaw
};

std::string sliding_gripper(const Sliding& form, const std::string& more = "") {
  std::vector<Part> parts;
  for (const double side : {1.0, -1.0}) {
    const bool first = side > 0;
    Part part{first ? "first" : "second", "palm", fmt::format("0 {} 0.05", side * form.offset),
              fmt::format("0 {} 0", side * form.sign), limit(form.lower, form.upper)};
    part.type = "prismatic";
    if (!first && form.coupled) part.more = "<mimic joint=\"first_j\"/>";
    if (form.shapes) {
      // The body lies outwards of the inner face, which is at y = 0 of the closed jaw.
      const double inner = -side * form.offset - side * form.sign * form.closed;
      part.box_at = fmt::format("0 {} 0.03", inner + side * 0.005);
      part.box = "0.02 0.01 0.06";
    }
    parts.push_back(part);
  }
  Part tool{"tool_tcp", "palm", "0 0 0.105", "0 0 1", ""};
  tool.type = "fixed";
  parts.push_back(tool);
  return urdf_of_parts("palm", parts, form.shapes ? kPalmShape : "") + more;
}

class SlidingGrippers : public testing::TestWithParam<Sliding> {};

TEST_P(SlidingGrippers, PadsFaceEachOtherAndMeetWhenClosed) {
  const Sliding& form = GetParam();
  const MadeHand made = set_up_parts(sliding_gripper(form));
  EXPECT_EQ(made.carrier(0), "first_j");
  EXPECT_EQ(made.carrier(1), "second_j");
  JointVector closed = made.with("first_j", form.closed), open = made.with("first_j", form.open);
  if (!form.coupled) {
    closed = JointVector::Constant(2, form.closed);
    open = JointVector::Constant(2, form.open);
  }
  EXPECT_LT((made.pad(0, closed) - made.pad(1, closed)).norm(), 1e-3);
  const double stroke_m = 2 * std::abs(form.open - form.closed);
  EXPECT_NEAR((made.pad(0, open) - made.pad(1, open)).norm(), stroke_m, 1e-3);
  EXPECT_NEAR(robot::widest_opening(made.table()), stroke_m + 0.02, 1e-3);  // 10 mm below both pads
  // The first jaw opens to +y, so that its pad looks to -y.
  EXPECT_LT((made.tip(0, open).linear().col(0) - Vec3(0, -1, 0)).norm(), 1e-6);
  EXPECT_LT((made.tip(1, open).linear().col(0) - Vec3(0, 1, 0)).norm(), 1e-6);
  EXPECT_LT((made.tip(0, open).linear().col(2) - Vec3::UnitZ()).norm(), 1e-6);
  // With shapes 8 mm before their end, without them at the tool centre point of the file.
  EXPECT_NEAR(made.pad(0, closed).z(), form.shapes ? 0.102 : 0.105, 1e-6);
  std::vector<Pose> poses;
  robot::forward_kinematics(made.table(), closed, poses);
  const Pose palm = poses[static_cast<std::size_t>(made.table().palm_frame)];
  EXPECT_LT((palm.linear().col(2) - Vec3::UnitZ()).norm(), 1e-6);
  EXPECT_LT((palm.linear().col(1) - Vec3::UnitY()).norm(), 1e-6);  // to the thumb
  EXPECT_THAT(made.result.to_check,
              Contains(HasSubstr(fmt::format("opens {:.1f} mm between its pads", 1e3 * stroke_m))));
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("gripper without a side")));
  if (form.shapes) return;
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("assumed to meet at the closed end")));
  // The tool centre point is no part of the palm's body.
  for (const RobotModel::Capsule& capsule : made.table().capsules) {
    if (capsule.frame < 0) continue;
    if (made.table().frames[static_cast<std::size_t>(capsule.frame)].joint >= 0) continue;
    EXPECT_LT(std::max(capsule.from.z(), capsule.to.z()), 0.06) << capsule.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Forms, SlidingGrippers,
    testing::Values(Sliding{"franka", 0, 0.04, 1, 0, true, true, 0, 0.04},
                    Sliding{"franka_without_shapes", 0, 0.04, 1, 0, true, false, 0, 0.04},
                    Sliding{"independent", 0, 0.04, 1, 0, false, true, 0, 0.04},
                    Sliding{"independent_without_shapes", 0, 0.04, 1, 0, false, false, 0, 0.04},
                    // Zero is open, and the joint closes upwards.
                    Sliding{"closes_upwards", 0, 0.03, -1, 0.03, true, true, 0.03, 0},
                    Sliding{"closes_upwards_without_shapes", 0, 0.03, -1, 0.03, true, false, 0.03,
                            0},
                    // As of the WSG 50: both ranges are negative.
                    Sliding{"negative", -0.055, -0.0027, -1, 0.0, true, true, -0.0027, -0.055}),
    [](const auto& form) { return std::string(form.param.name); });

TEST(Grippers, WithoutShapesAndEndsTheyAreAskedFor) {
  const Sliding both_ways{"", -0.04, 0.04, 1, 0, true, false, 0, 0.04};
  EXPECT_THAT([&] { set_up_parts(sliding_gripper(both_ways)); },
              ThrowsMessage<InputError>(testing::AllOf(
                  HasSubstr("neither shapes nor limits tell how the jaws first and second close"),
                  HasSubstr("--limit first_j=LOWER..UPPER"))));
  SetupRequest request;
  request.limits["first_j"] = {0, 0.04};
  EXPECT_EQ(set_up_parts(sliding_gripper(both_ways), request).carrier(0), "first_j");
}

/// Two bars on each side, which one joint drives so that the tips stay parallel, as of the 2F-85.
std::string linkage_gripper(bool shapes) {
  std::vector<Part> parts;
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    const auto mimic = [&](double factor) {
      return fmt::format("<mimic joint=\"left_knuckle_j\" multiplier=\"{}\"/>", factor);
    };
    Part knuckle{name + "_knuckle", "palm", fmt::format("{} 0 0.05", side * 0.03), "0 -1 0",
                 side > 0 ? limit(0, 0.8) : limit(-0.8, 0)};
    if (side < 0) knuckle.more = mimic(-1);
    Part inner{name + "_inner", "palm",           fmt::format("{} 0 0.06", side * 0.012),
               "0 -1 0",        limit(-0.8, 0.8), mimic(side)};
    Part tip{name + "_end", name + "_knuckle", fmt::format("{} 0 0.045", side * 0.037),
             "0 -1 0",      limit(-0.8, 0.8),  mimic(-side)};
    if (shapes) {
      tip.box_at = fmt::format("{} 0 0.025", side * -0.018);
      tip.box = "0.01 0.02 0.05";
      inner.box_at = "0 0 0.02";
      inner.box = "0.005 0.005 0.04";
    }
    parts.insert(parts.end(), {knuckle, inner, tip});
  }
  return urdf_of_parts("palm", parts, shapes ? kPalmShape : "");
}

TEST(Grippers, ALinkagesTipsAreItsJaws) {
  const MadeHand made = set_up_parts(linkage_gripper(true));
  EXPECT_EQ(made.carrier(0), "left_end_j");
  EXPECT_EQ(made.carrier(1), "right_end_j");
  const JointVector open = made.with("left_knuckle_j", 0);
  // Tips at 67 mm, inner faces 23 mm before them: 2 x 44 mm apart, and parallel.
  EXPECT_NEAR((made.pad(0, open) - made.pad(1, open)).norm(), 0.088, 1e-3);
  EXPECT_LT((made.tip(0, open).linear().col(0) - Vec3(-1, 0, 0)).norm(), 1e-6);
  EXPECT_LT((made.tip(1, open).linear().col(0) - Vec3(1, 0, 0)).norm(), 1e-6);
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("left_inner is no finger")));
  // Without shapes the pads meet at the closed end of the range.
  const MadeHand bare = set_up_parts(linkage_gripper(false));
  const JointVector closed = bare.with("left_knuckle_j", 0.8);
  EXPECT_LT((bare.pad(0, closed) - bare.pad(1, closed)).norm(), 1e-6);
  EXPECT_LT((bare.tip(0, open).linear().col(0) - Vec3(-1, 0, 0)).norm(), 1e-6);
  EXPECT_THAT(bare.result.to_check,
              Contains(HasSubstr("tip of thumb: the end of the finger is unknown")));
}

/// A jaw of 80 mm that swings about y beside a fixed one, on the side `side` of it, at the end of
/// an arm; `closed` and `open` are the limits of its joint in the sense of the axis.
std::string one_jaw(double side, double sense, bool shapes = true, const char* name = "swing") {
  std::vector<Part> parts = hobby_arm();
  Part fixed{"still", "l5", "0 0 0.02", "0 0 1", ""};
  fixed.type = "fixed";
  Part moving{name, "l5", fmt::format("{} 0 0.02", side * 0.012),
              fmt::format("0 {} 0", side * sense), sense > 0 ? limit(-0.1, 1.6) : limit(-1.6, 0.1)};
  if (shapes) {
    fixed.box_at = fmt::format("{} 0 0.05", side * -0.008);
    fixed.box = "0.008 0.02 0.1";
    moving.box_at = fmt::format("{} 0 0.04", side * 0.004);
    moving.box = "0.008 0.02 0.08";
  }
  parts.insert(parts.end(), {fixed, moving});
  if (!shapes) {
    parts.push_back({"tool_tip", "l5", "0 0 0.1", "0 0 1", ""});
    parts.back().type = "fixed";
    parts.push_back({"swing_tip", name, "0 0 0.08", "0 0 1", ""});
    parts.back().type = "fixed";
  }
  return urdf_of_parts("base", parts);
}

TEST(Grippers, AJawBesideAFixedOneIsAGripper) {
  for (const double side : {1.0, -1.0}) {
    for (const double sense : {1.0, -1.0}) {
      SCOPED_TRACE(fmt::format("side {}, sense {}", side, sense));
      const MadeHand made = set_up_parts(one_jaw(side, sense));
      ASSERT_EQ(made.table().joints(), 6u);
      EXPECT_EQ(made.carrier(0), "swing_j");
      EXPECT_EQ(made.carrier(1), "still");
      EXPECT_THAT(made.result.text, HasSubstr("{name: arm, first: l1_j, last: l5_j}"));
      EXPECT_THAT(made.result.to_check, Contains(HasSubstr("index = still, the fixed jaw")));
      // Where the faces meet: the moving one is at -side * 0 from its frame, the fixed one at -4
      // mm.
      const double touching = -sense * std::atan2(0.016, 0.08);
      const JointVector closed = made.with(
          "swing_j", std::clamp(touching, sense > 0 ? -0.1 : -1.6, sense > 0 ? 1.6 : 0.1));
      const Pose thumb = made.tip(0, closed), index = made.tip(1, closed);
      EXPECT_GT(-thumb.linear().col(0).dot(index.linear().col(0)), 0.98);
      EXPECT_GT(index.linear().col(0).x() * side, 0.98);  // it looks at the moving jaw
      EXPECT_GT(index.linear().col(2).z(), 0.98);
      EXPECT_LT((made.pad(0, closed) - made.pad(1, closed)).norm(), 0.012);
      const JointVector open = made.with("swing_j", sense * 1.6);
      EXPECT_GT((made.pad(0, open) - made.pad(1, open)).norm(), 0.09);
    }
  }
}

TEST(Grippers, AJawWithoutShapesIsKnownByTheTips) {
  const MadeHand made = set_up_parts(one_jaw(1, 1, false));
  EXPECT_EQ(made.carrier(0), "swing_j");
  EXPECT_THAT(made.result.text, HasSubstr("{name: arm, first: l1_j, last: l5_j}"));
  EXPECT_GT(made.tip(0, made.with("swing_j", 0)).linear().col(0).dot(-Vec3::UnitX()), 0.9);
}

TEST(Grippers, ASlidingJawBesideAFixedOneIsAGripper) {
  std::vector<Part> parts = hobby_arm();
  Part fixed{"still", "l5", "0 0 0.02", "0 0 1", ""};
  fixed.type = "fixed";
  fixed.box_at = "-0.005 0 0.05";
  fixed.box = "0.01 0.02 0.1";
  Part moving{"slide", "l5", "0 0 0.02", "1 0 0", limit(0, 0.06)};
  moving.type = "prismatic";
  moving.box_at = "0.005 0 0.06";
  moving.box = "0.01 0.02 0.08";
  parts.insert(parts.end(), {fixed, moving});
  const MadeHand made = set_up_parts(urdf_of_parts("base", parts));
  EXPECT_EQ(made.carrier(0), "slide_j");
  EXPECT_EQ(made.carrier(1), "still");
  EXPECT_LT((made.tip(0, made.with("slide_j", 0)).linear().col(0) + Vec3::UnitX()).norm(), 1e-6);
  EXPECT_NEAR(
      (made.pad(0, made.with("slide_j", 0.06)) - made.pad(1, made.with("slide_j", 0))).norm(), 0.06,
      1e-3);
}

TEST(Grippers, ALastJointThatIsNoJawIsTheArms) {
  // A wrist that turns about the arm, and one that bends, with a plate that is as wide as the
  // wrist.
  for (const char* axis : {"0 0 1", "0 1 0"}) {
    std::vector<Part> parts = hobby_arm(6);
    parts[4].box_at = "0 0 0.06";
    parts[4].box = "0.06 0.06 0.16";  // reaches 20 mm beyond the last joint
    parts[5].axis = axis;
    parts[5].box_at = "0 0 0.03";
    parts[5].box = "0.05 0.05 0.06";
    const MadeHand made = set_up_parts(urdf_of_parts("base", parts));
    EXPECT_EQ(made.table().tips.size(), 1u) << axis;
    EXPECT_EQ(made.table().tips[0].finger, -1) << axis;
  }
}

TEST(Grippers, APropellerIsNoFinger) {
  const Sliding jaws{"", 0, 0.04, 1, 0.006, false, true, 0, 0.04};
  struct Decoration {
    const char *type, *axis, *limits, *reason;
  };
  for (const Decoration& form :
       {Decoration{"continuous", "0 0 1", "<limit velocity=\"3\" effort=\"1\"/>", "turns freely"},
        Decoration{"revolute", "0 0 1",
                   "<limit lower=\"-3.1416\" upper=\"3.1416\" velocity=\"3\" effort=\"1\"/>",
                   "turns freely"},
        Decoration{"revolute", "1 0 0",
                   "<limit lower=\"-0.3\" upper=\"0.3\" velocity=\"3\" effort=\"1\"/>",
                   "comes near to no other"}}) {
    std::string text = sliding_gripper(jaws);
    text.replace(text.find("</robot>"), 8, "");
    text += fmt::format(
        "<link name=\"prop\">{}</link><joint name=\"spin\" type=\"{}\"><parent link=\"palm\"/>"
        "<child link=\"prop\"/><origin xyz=\"0 0 -0.03\"/><axis xyz=\"{}\"/>{}</joint></robot>",
        box_shape("0 0 0.01", "0.005 0.06 0.01"), form.type, form.axis, form.limits);
    const MadeHand made = set_up_parts(text);
    EXPECT_EQ(made.table().tips.size(), 2u);
    EXPECT_EQ(made.carrier(0), "first_j");
    EXPECT_EQ(made.table().joint_names.size(), 2u);  // the propeller is held
    EXPECT_THAT(made.result.to_check,
                Contains(testing::AllOf(HasSubstr("prop is no finger"), HasSubstr(form.reason))));
  }
}

TEST(Grippers, SidesAreReadFromNamesAndTheBody) {
  const Sliding form{"", 0, 0.04, 1, 0, true, true, 0, 0.04};
  std::string text = sliding_gripper(form);
  const auto with_name = [&](const std::string& palm) {
    return std::regex_replace(text, std::regex("\"palm\""), "\"" + palm + "\"");
  };
  EXPECT_EQ(set_up_parts(with_name("left_palm")).table().side, Side::left);
  EXPECT_EQ(set_up_parts(with_name("gripperLeft")).table().side, Side::left);
  EXPECT_EQ(set_up_parts(with_name("r_gripper")).table().side, Side::right);
  EXPECT_EQ(set_up_parts(with_name("shelf")).table().side, Side::right);  // no word of it
  // A left palm's y points away from the thumb.
  const MadeHand left = set_up_parts(with_name("left_palm"));
  std::vector<Pose> poses;
  robot::forward_kinematics(left.table(), left.with("first_j", 0), poses);
  const Pose palm = poses[static_cast<std::size_t>(left.table().palm_frame)];
  EXPECT_LT((palm.linear().col(1) + Vec3::UnitY()).norm(), 1e-6);
}

}  // namespace
}  // namespace morphe::setup
