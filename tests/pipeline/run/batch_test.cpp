#include "pipeline/run/batch.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace morphe::run {
namespace {

/// Demonstrations 0 … count-1; odd ones are executable, every seventh fails.
Batch numbered_batch(int count, std::vector<std::string>& written) {
  Batch batch;
  batch.next = [count, made = 0]() mutable {
    if (made == count) return std::unique_ptr<Demonstration>();
    auto demonstration = std::make_unique<Demonstration>();
    demonstration->name = std::to_string(made++);
    return demonstration;
  };
  batch.plan = [](const Demonstration& demonstration) {
    const int number = std::stoi(demonstration.name);
    if (number % 7 == 6) throw std::runtime_error("broken");
    DemonstrationOutcome outcome;
    Plan plan;
    plan.reason = number % 2 ? Reason::none : Reason::smoothing_collision;
    outcome.plans.push_back(plan);
    return outcome;
  };
  batch.write = [&written](const DemonstrationOutcome& outcome) {
    written.push_back(outcome.demonstration);
  };
  return batch;
}

TEST(Batch, WritesInTheOrderOfTheDatasetWhateverTheThreads) {
  for (const int jobs : {1, 2, 8}) {
    std::vector<std::string> written;
    run_batch(numbered_batch(100, written), jobs);
    ASSERT_EQ(written.size(), 100U);
    for (int i = 0; i < 100; ++i) {
      EXPECT_EQ(written[static_cast<std::size_t>(i)], std::to_string(i));
    }
  }
}

TEST(Batch, OneBrokenDemonstrationDoesNotStopTheOthers) {
  std::vector<std::string> written;
  const BatchSummary summary = run_batch(numbered_batch(14, written), 2);
  EXPECT_EQ(summary.demonstrations, 14);
  EXPECT_EQ(summary.failed, 2);
  EXPECT_EQ(summary.movements, 12);
  EXPECT_EQ(summary.executable, 6);  // 1 3 5 7 9 11; 13 is broken
  EXPECT_EQ(summary.infeasible, 6);
  EXPECT_EQ(summary.reasons.at("smoothing_collision"), 6);
}

TEST(Batch, CountsThePlansOfEachBranch) {
  DemonstrationOutcome outcome;
  for (const char* word : {"elbow up", "elbow down", "elbow up", ""}) {
    Plan& plan = outcome.plans.emplace_back();
    if (*word != 0) plan.branch = {0, {word, "wrist flipped"}, {"elbow up -> down at 0.50 s"}};
  }
  BatchSummary summary = summary_of(outcome);
  const std::map<std::string, int> once{{"elbow down, wrist flipped", 1},
                                        {"elbow up, wrist flipped", 2}};
  EXPECT_EQ(summary.branches, once);
  EXPECT_EQ(deserialize_summary(serialize_summary(summary)).branches, once);
  add(summary_of(outcome), summary);
  EXPECT_EQ(summary.branches.at("elbow up, wrist flipped"), 4);
}

TEST(Batch, CountsFramesForEachSecondOfACore) {
  DemonstrationOutcome outcome;
  for (const int frames : {120, 0, 80}) {  // the second was never mapped
    Plan plan;
    plan.reason = Reason::smoothing_collision;
    plan.mapped.position = JointRows::Zero(frames, 7);
    plan.mapped.tip_error = JointRows::Zero(0, 0);
    outcome.plans.push_back(plan);
  }
  outcome.stage_cpu_s = {{"certify", 0.0375}, {"map", 0.3}, {"segment", 1e-4}, {"retime", 0.0624}};
  BatchSummary summary = summary_of(outcome);
  EXPECT_EQ(summary.movements, 3);
  EXPECT_EQ(summary.mapped, 2);
  EXPECT_EQ(summary.frames, 200);
  EXPECT_DOUBLE_EQ(frames_per_cpu_second(summary), 500);
  EXPECT_DOUBLE_EQ(stage_ms_per_movement(summary).at("map"), 150);
  EXPECT_EQ(speed_text(summary),
            "200 frames; 500 frames/s per core; 200 ms per movement: map 150, retime "
            "31, certify 19");
  add(summary_of(outcome), summary);  // as much again in as much more time
  EXPECT_EQ(summary.frames, 400);
  EXPECT_DOUBLE_EQ(frames_per_cpu_second(summary), 500);
  EXPECT_DOUBLE_EQ(stage_ms_per_movement(summary).at("map"), 150);
  EXPECT_EQ(speed_text({}), "");
  EXPECT_EQ(frames_per_cpu_second({}), 0);
}

}  // namespace
}  // namespace morphe::run
