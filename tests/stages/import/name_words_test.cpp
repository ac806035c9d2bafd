#include "stages/import/recording/name_words.hpp"

#include <gtest/gtest.h>

#include <string>

namespace morphe::imports {
namespace {

std::string text_of(const std::vector<NameWord>& words) {
  std::string text;
  for (const NameWord& word : words) text += (text.empty() ? "" : " ") + word.text;
  return text;
}

TEST(NameWords, LettersNumbersAndCapitals) {
  const std::pair<const char*, const char*> known[] = {{"ADL001DR2", "adl 1 dr 2"},
                                                       {"RElbow", "r elbow"},
                                                       {"lHand", "l hand"},
                                                       {"T-pose 01", "t pose 1"},
                                                       {"Bip01 R Hand", "bip 1 r hand"},
                                                       {"000", "0"},
                                                       {"", ""},
                                                       {"__.--", ""},
                                                       {"Käthe_2", "käthe 2"}};
  for (const auto& [name, words] : known) EXPECT_EQ(text_of(split_name(name)), words) << name;
  EXPECT_EQ(split_name("ADL001DR2")[1].end, 6u);
}

TEST(NameWords, StaticTrialsAndWhose) {
  const std::tuple<const char*, bool, const char*> known[] = {
      {"ADL001_static", true, "adl 1"},
      {"static_P03", true, "p 3"},
      {"Static 01", true, ""},
      {"Cal 02", true, ""},
      {"annastatic", true, "anna"},
      {"P02 T-Pose", true, "p 2"},
      {"P02_Calibration_3", true, "p 2"},
      {"sub-07_neutral", true, "sub 7"},
      {"Trial 03 static", true, ""},
      {"ADL001DR2", false, "adl 1 dr 2"},
      {"t_reach", false, "t reach"},
      {"calm_reach", false, "calm reach"},
      {"postcard", false, "postcard"},
  };
  for (const auto& [name, is_static, whose] : known) {
    const StaticTrialName read = parse_static_name(name);
    EXPECT_EQ(read.is_static, is_static) << name;
    EXPECT_EQ(text_of(read.person_words), whose) << name;
  }
}

TEST(NameWords, NaturalOrder) {
  EXPECT_TRUE(natural_less("trial2", "trial10"));
  EXPECT_FALSE(natural_less("trial10", "trial2"));
  EXPECT_TRUE(natural_less("P01", "P01_a"));
  EXPECT_TRUE(natural_less("a1", "a01") != natural_less("a01", "a1"));
}

}  // namespace
}  // namespace morphe::imports
