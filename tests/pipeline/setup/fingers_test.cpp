// Hands of three to seven fingers made of boxes: which chain is which finger, and what is left out.
#include <gmock/gmock.h>

#include <regex>

#include "tests/pipeline/setup/primitive_hands.hpp"

namespace morphe::setup {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A finger along z that stands at y on the palm, closing towards +x; three hinges, a box each.
void add_finger(std::vector<Part>& parts, const std::string& name, double y,
                const std::string& parent = "palm", const std::string& root = "") {
  const std::vector<double> lengths_m = {0.045, 0.03, 0.025};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string above = k == 0 ? parent : fmt::format("{}_{}", name, k - 1);
    const std::string at = k == 0 ? (root.empty() ? fmt::format("0 {} 0.08", y) : root)
                                  : fmt::format("0 0 {}", lengths_m[k - 1]);
    Part part{fmt::format("{}_{}", name, k), above, at, "0 1 0", limit(0, 1.5)};
    part.box_at = fmt::format("0 0 {}", lengths_m[k] / 2);
    part.box = fmt::format("0.014 0.014 {}", lengths_m[k]);
    parts.push_back(part);
  }
}

/// A thumb beside the palm at y, in front of it, that closes towards -x.
void add_thumb(std::vector<Part>& parts, const std::string& name, double y) {
  for (std::size_t k = 0; k < 3; ++k) {
    Part part{fmt::format("{}_{}", name, k), k == 0 ? "palm" : fmt::format("{}_{}", name, k - 1),
              k == 0 ? fmt::format("0.03 {} 0.02", y) : "0 0 0.04", "0 -1 0",
              limit(k == 0 ? -0.3 : 0, 1.2)};
    part.box_at = "0 0 0.02";
    part.box = "0.014 0.014 0.04";
    parts.push_back(part);
  }
}

const std::string kPalm = box_shape("0 0 0.04", "0.03 0.09 0.08");

TEST(Fingers, AreOrderedByWhereTheirTipsStand) {
  // The little finger begins with a joint of the palm that lies inside of the ring finger's.
  std::vector<Part> parts;
  add_finger(parts, "c", -0.011);
  add_finger(parts, "a", 0.033);
  parts.push_back({"palm_half", "palm", "0 -0.008 0.02", "0 0 1", limit(0, 0.5)});
  add_finger(parts, "d", 0, "palm_half", "0 -0.025 0.06");
  add_finger(parts, "b", 0.011);
  add_thumb(parts, "t", 0.045);
  const MadeHand made = set_up_parts(urdf_of_parts("palm", parts, kPalm));
  std::vector<std::string> carriers;
  for (int finger = 0; finger < 5; ++finger) carriers.push_back(made.carrier(finger));
  EXPECT_THAT(carriers, ElementsAre("t_2_j", "a_2_j", "b_2_j", "c_2_j", "d_2_j"));
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("a right hand")));
}

TEST(Fingers, OfThreeOrFourHaveAThumbAndASide) {
  for (const int count : {3, 4}) {
    for (const double side : {1.0, -1.0}) {
      std::vector<Part> parts;
      for (int k = 0; k < count - 1; ++k)
        add_finger(parts, fmt::format("f{}", k), side * (0.025 - 0.025 * k));
      add_thumb(parts, "t", side * 0.045);
      const MadeHand made = set_up_parts(urdf_of_parts("palm", parts, kPalm));
      ASSERT_EQ(made.table().tips.size(), static_cast<std::size_t>(count));
      EXPECT_EQ(made.carrier(0), "t_2_j");
      for (int k = 0; k < count - 1; ++k) EXPECT_EQ(made.carrier(k + 1), fmt::format("f{}_2_j", k));
      EXPECT_EQ(made.table().side, side > 0 ? Side::right : Side::left);
    }
  }
}

TEST(Fingers, BeyondFiveAreHeldAndSaid) {
  std::vector<Part> parts;
  for (int k = 0; k < 6; ++k) add_finger(parts, fmt::format("g{}", k), 0.055 - 0.022 * k);
  add_thumb(parts, "t", 0.06);
  const MadeHand made = set_up_parts(urdf_of_parts("palm", parts, kPalm));  // which reads it back
  EXPECT_EQ(made.table().tips.size(), 5u);
  EXPECT_EQ(made.table().joints(), 15u);
  EXPECT_EQ(made.carrier(1), "g0_2_j");
  EXPECT_EQ(made.carrier(4), "g3_2_j");
  for (const char* held : {"g4_2 is no finger", "g5_2 is no finger"})
    EXPECT_THAT(made.result.to_check,
                Contains(testing::AllOf(HasSubstr(held), HasSubstr("a person has 5 fingers"))));
}

TEST(Fingers, AChainBesideNamedFingersIsNone) {
  std::vector<Part> parts;
  add_finger(parts, "cover", 0.03);
  for (const auto& [name, y] : {std::pair{"index", 0.01}, {"middle", -0.01}, {"ring", -0.03}})
    add_finger(parts, name, y);
  add_thumb(parts, "thumb", 0.045);
  const MadeHand made = set_up_parts(urdf_of_parts("palm", parts, kPalm));
  EXPECT_EQ(made.table().tips.size(), 4u);
  EXPECT_EQ(made.carrier(1), "index_2_j");
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("cover_2 is no finger")));
}

TEST(Fingers, AJointOfAllFingersDoesNotMakeThemAGripper) {
  std::vector<Part> parts;
  for (const auto& [name, y] : {std::pair{"index", 0.03}, {"middle", 0.01}, {"ring", -0.01}})
    add_finger(parts, name, y);
  add_thumb(parts, "thumb", 0.045);
  std::string text = urdf_of_parts("palm", parts, kPalm);
  for (const Part& part : parts)
    if (part.link != "index_0")
      text = std::regex_replace(text,
                                std::regex("(<joint name=\"" + part.link + "_j\"[^\\n]*)</joint>"),
                                "$1<mimic joint=\"index_0_j\"/></joint>");
  const MadeHand made = set_up_parts(text);
  EXPECT_EQ(made.table().joints(), 1u);
  EXPECT_EQ(made.table().tips.size(), 4u);
  EXPECT_EQ(made.carrier(3), "ring_2_j");
}

TEST(Fingers, PadsOfSlidingFingersLookInwards) {
  // A chuck: three jaws slide towards the middle.
  std::vector<Part> parts;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    const Vec3 at = 0.01 * out, body = 0.005 * out;
    Part jaw{fmt::format("jaw{}", k), "palm", fmt::format("{} {} 0.05", at.x(), at.y()),
             fmt::format("{} {} 0", out.x(), out.y()), limit(0, 0.03)};
    jaw.type = "prismatic";
    jaw.box_at = fmt::format("{} {} 0.03", body.x(), body.y());
    jaw.box = "0.01 0.01 0.06";
    parts.push_back(jaw);
  }
  const MadeHand made = set_up_parts(urdf_of_parts("palm", parts, kPalm));
  ASSERT_EQ(made.table().tips.size(), 3u);
  for (int finger = 0; finger < 3; ++finger) {
    const Pose tip = made.tip(finger, JointVector::Zero(3));
    const Vec3 inwards = -(Vec3(tip.translation().x(), tip.translation().y(), 0).normalized());
    EXPECT_GT(tip.linear().col(0).dot(inwards), 0.99) << finger;
    EXPECT_GT(tip.linear().col(2).z(), 0.99) << finger;
  }
}

TEST(Fingers, ASideThatNamesContradictIsSaid) {
  std::vector<Part> parts;
  for (int k = 0; k < 3; ++k) add_finger(parts, fmt::format("f{}", k), 0.025 - 0.025 * k);
  add_thumb(parts, "t", 0.045);
  const std::string text = std::regex_replace(urdf_of_parts("palm", parts, kPalm),
                                              std::regex("\"palm\""), "\"left_palm\"");
  const MadeHand made = set_up_parts(text);
  EXPECT_EQ(made.table().side, Side::right);
  EXPECT_THAT(made.result.to_check, Contains(HasSubstr("although left_palm says left")));
}

}  // namespace
}  // namespace morphe::setup
