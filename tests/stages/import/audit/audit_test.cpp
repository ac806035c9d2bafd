#include "stages/import/audit/audit.hpp"

#include <gtest/gtest.h>

#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

Doubt spike(double time_s) {
  Doubt doubt;
  doubt.flag.code = FlagCode::spike;
  doubt.flag.begin_s = doubt.flag.end_s = time_s;
  return doubt;
}

Doubt mended_spike(double time_s) {
  Doubt doubt = spike(time_s);
  doubt.mend = [](Demonstration& recording) { recording.task += "mended"; };
  return doubt;
}

Doubt tilted() {
  Doubt doubt;
  doubt.flag.code = FlagCode::vertical;
  doubt.question = {"axes", "x -z y"};
  return doubt;
}

TEST(AnswerDoubts, MendsWhatIsCertainAndFlagsTheRest) {
  Demonstration recording;
  EXPECT_FALSE(answer_doubts({mended_spike(1), spike(2)}, {}, recording));
  ASSERT_EQ(recording.flags.size(), 2u);
  EXPECT_EQ(recording.flags[0].response, FlagResponse::mended);
  EXPECT_EQ(recording.flags[1].response, FlagResponse::flagged);
  EXPECT_EQ(recording.task, "mended");
}

TEST(AnswerDoubts, ReturnsTheFirstQuestion) {
  Demonstration recording;
  const std::optional<Doubt> asked = answer_doubts({spike(1), tilted(), spike(2)}, {}, recording);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->question->value, "x -z y");
  EXPECT_EQ(recording.flags.size(), 1u);
}

TEST(AnswerDoubts, ChangesAndAsksNothingThatTheUserAccepts) {
  Demonstration recording;
  const AuditInput input{.file = "a.csv", .accepted = {FlagCode::spike, FlagCode::vertical}};
  EXPECT_FALSE(answer_doubts({mended_spike(1), tilted()}, input, recording));
  ASSERT_EQ(recording.flags.size(), 2u);
  EXPECT_EQ(recording.flags[0].response, FlagResponse::accepted);
  EXPECT_EQ(recording.flags[1].response, FlagResponse::accepted);
  EXPECT_EQ(recording.task, "");
}

TEST(AuditMovement, TakesTheFlagsThatOverlapIt) {
  Demonstration recording;
  RecordingFlag whole;
  whole.code = FlagCode::mirrored;
  recording.flags = {spike(0.5).flag, spike(1.0).flag, spike(2.5).flag, whole};
  const HumanMotion motion;
  Movement movement;
  movement.begin_s = 1;
  movement.end_s = 2;
  const auto flags = audit_movement({recording, motion, movement}, {});
  ASSERT_GE(flags.size(), 2u);
  EXPECT_EQ(flags[0].begin_s, 1.0);
  EXPECT_EQ(flags[1].code, FlagCode::mirrored);
}

TEST(RefusedFlag, IsOneOfTheOptionsThatNobodyMendedOrAccepted) {
  AuditOptions options;
  options.refuse = {FlagCode::spike};
  std::vector<RecordingFlag> flags = {tilted().flag, spike(1).flag, spike(2).flag};
  flags[1].response = FlagResponse::mended;
  EXPECT_EQ(refused_flag(flags, options), &flags[2]);
  flags[2].response = FlagResponse::accepted;
  EXPECT_EQ(refused_flag(flags, options), nullptr);
  flags[2].response = FlagResponse::flagged;
  options.refuse = {};
  EXPECT_EQ(refused_flag(flags, options), nullptr);
}

}  // namespace
}  // namespace morphe::imports
