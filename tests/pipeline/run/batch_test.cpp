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
    plan.reason = number % 2 ? Reason::none : Reason::collision;
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
  EXPECT_EQ(summary.reasons.at("collision"), 6);
}

}  // namespace
}  // namespace morphe::run
