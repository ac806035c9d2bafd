#include "stages/export/table/condition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"

namespace morphe::exports {
namespace {

/// A plan with a clearance of 3 mm, a tempo of 1.5 and an unknown target clearance, repaired.
Plan some_plan() {
  Plan plan;
  plan.demonstration = "drink 1";
  plan.task = "drink";
  plan.reason = Reason::none;
  plan.repaired = true;
  plan.certificate.clearance = 0.003;
  plan.certificate.duration_ratio = 1.5;
  plan.certificate.upper_arm_error_mean = 0.1;
  plan.certificate.humanlikeness_final = 0.0123;
  return plan;
}

bool holds(const std::string& text) {
  const RobotModel robot;
  const Plan plan = some_plan();
  return Condition(text).holds({robot, plan, "train"});
}

std::string error_of(const std::string& text) {
  try {
    Condition condition(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Condition, ComparesNumbersInTheirUnits) {
  for (const char* text :
       {"clearance > 2 mm", "clearance>2mm", "clearance >= 3 mm", "clearance = 0.3 cm",
        "clearance < 3001 um", "clearance <= 0.003 m", "tempo < 1.8", "tempo >= 150 %",
        "upper_arm_error < 6 deg", "upper_arm_error > 99e-3 rad", "humanlikeness > 122 cm^2",
        "movement = 0", "tempo != -1.5"})
    EXPECT_TRUE(holds(text)) << text;
  for (const char* text : {"clearance > 3 mm", "clearance < 3 mm", "tempo > 1.8",
                           "upper_arm_error > 6 deg", "movement > 0"})
    EXPECT_FALSE(holds(text)) << text;
}

TEST(Condition, ComparesWordsTextsAndFlags) {
  for (const char* text :
       {"status = executable", "status == 'executable'", "task != pour", "repaired",
        "repaired = true", "demonstration = 'drink 1'", "reason = \"\"", "split = train"})
    EXPECT_TRUE(holds(text)) << text;
  for (const char* text : {"status = infeasible", "not repaired", "split != train"})
    EXPECT_FALSE(holds(text)) << text;
}

TEST(Condition, BindsAndCloserThanOr) {
  EXPECT_TRUE(holds("tempo < 1 and tempo < 1 or repaired"));
  EXPECT_TRUE(holds("repaired or tempo < 1 and tempo < 1"));
  EXPECT_FALSE(holds("(repaired or tempo < 1) and tempo < 1"));
  EXPECT_TRUE(holds("not tempo < 1 and repaired"));
  EXPECT_FALSE(holds("not (tempo < 1 or repaired)"));
  EXPECT_TRUE(holds("not not repaired"));
}

TEST(Condition, AnUnknownValueNeitherSatisfiesNorContradicts) {
  EXPECT_FALSE(holds("clearance_target > 0 m"));
  EXPECT_FALSE(holds("not clearance_target > 0 m"));
  EXPECT_FALSE(holds("clearance_target > 0 m or tempo < 1"));
  EXPECT_TRUE(holds("clearance_target > 0 m or repaired"));
  EXPECT_TRUE(holds("not (clearance_target > 0 m and tempo < 1)"));
  EXPECT_FALSE(holds("not (clearance_target > 0 m and repaired)"));
}

TEST(Condition, SaysWhereItIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"clearence > 2 mm",
       "at character 1: 'clearence' is not a column; did you mean 'clearance'?"},
      {"tempo < 1 and hoppla = 2", "at character 15: 'hoppla' is not a column; the columns are "},
      {"clearance > 2", "at character 13: clearance has a unit: write 2 m, cm, mm, um"},
      {"clearance > 2 s", "at character 15: 's' is not a unit of clearance: m, cm, mm, um"},
      {"clearance >", "at character 12: a number was expected"},
      {"clearance 2 mm", "at character 11: one of < <= > >= = != was expected after clearance"},
      {"clearance > mm", "at character 13: a number was expected"},
      {"tempo < 1.8 tempo", "at character 13: 'tempo' is not a unit of tempo: %"},
      {"repaired 2", "at character 10: 'and', 'or' or the end was expected"},
      {"(tempo < 1", "at character 1: the parenthesis is not closed"},
      {"tempo < 1)", "at character 10: 'and', 'or' or the end was expected"},
      {"status = exectable", "at character 10: status is never 'exectable'; did you mean 'exec"},
      {"status < executable", "at character 8: status is not a number"},
      {"repaired = maybe", "at character 12: repaired is true or false"},
      {"task = 'drink", "at character 8: the quote is not closed"},
      {"tempo < 1e999", "at character 9: is not a finite number"},
      {"tempo < 1 & repaired", "at character 11: '&' was not expected"},
      {"", "at character 1: the name of a column was expected"},
      {"not", "at character 4: the name of a column was expected"},
  };
  for (const auto& [text, message] : cases)
    EXPECT_THAT(error_of(text), testing::HasSubstr(message)) << text;
}

TEST(Condition, AnErrorIsOneLineOfPrintableCharacters) {
  const std::string error = error_of("tempo < 1\n\x1b[31m");
  EXPECT_EQ(error.find_first_of("\n\x1b"), std::string::npos) << error;
}

TEST(Condition, DoesNotExhaustTheStack) {
  EXPECT_THAT(error_of(std::string(100000, '(')), testing::HasSubstr("is nested too deeply"));
  std::string text;
  for (int k = 0; k < 100000; ++k) text += "not ";
  EXPECT_THAT(error_of(text + "repaired"), testing::HasSubstr("is nested too deeply"));
}

}  // namespace
}  // namespace morphe::exports
