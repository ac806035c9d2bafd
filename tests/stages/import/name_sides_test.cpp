#include "stages/import/recording/name_sides.hpp"

#include <gmock/gmock.h>

namespace morphe::imports {
namespace {

/// R, L or - for the body's side, then the first letter of the joint's side or -.
std::string sides_in(const std::vector<std::string>& names) {
  std::string text;
  for (const NameSide& side : sides_of_names(names)) {
    text += side.body ? (*side.body == Side::right ? 'R' : 'L') : '-';
    text += "-lmru"[static_cast<std::size_t>(side.joint)];
    text += ' ';
  }
  return text;
}

TEST(NameSides, FinalLBesideFinalMIsLateral) {
  EXPECT_EQ(sides_in({"gh", "EpL", "EpM", "us", "rs"}), "-- -l -m -u -r ");
  EXPECT_EQ(sides_in({"elbow_l", "elbow_m"}), "-l -m ");
  EXPECT_EQ(sides_in({"LEpi", "MEpi"}), "-l -m ");
  EXPECT_EQ(sides_in({"WrR", "WrU"}), "-r -u ");
}

TEST(NameSides, OppositeSideInTheFileMakesItASide) {
  EXPECT_EQ(sides_in({"elbow_l", "elbow_r", "elbow_m"}), "L- R- -- ");
  EXPECT_EQ(sides_in({"ElbowL", "ElbowR"}), "L- R- ");
  EXPECT_EQ(sides_in({"hand_l"}), "L- ");
}

TEST(NameSides, FirstSideOfANameCounts) {
  EXPECT_EQ(sides_in({"R_FAL", "L_FAL", "R_TAM"}), "R- L- R- ");
  EXPECT_EQ(sides_in({"REpL", "REpM"}), "Rl Rm ");
  EXPECT_EQ(sides_in({"P1:RightElbowL", "P1:RightElbowM"}), "Rl Rm ");
  EXPECT_EQ(sides_in({"RLEP", "RMEP", "LSHO"}), "R- R- L- ");
}

TEST(NameSides, WordsOfOtherLanguages) {
  EXPECT_EQ(sides_in({"Hand links", "main_droite", "左肩", "cup"}), "L- R- L- -- ");
}

}  // namespace
}  // namespace morphe::imports
