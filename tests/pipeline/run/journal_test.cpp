#include "pipeline/run/journal.hpp"

#include <gmock/gmock.h>

#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("morphe_journal_") + test->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~JournalTest() override { fs::remove_all(folder); }

  std::unique_ptr<Journal> open(const Shard& shard = {}, bool fresh = false) const {
    return Journal::write(folder, "morphe 1.2.3", shard, fresh);
  }
  /// A run of "a", "b" and "c", which stand at 0, 2 and 5 of a dataset.
  static void begin(Journal& journal) {
    RunIdentity identity;
    identity.software = "morphe 1.2.3";
    identity.demonstrations = 6;
    journal.begin(identity, "seed: 1\n", [](const auto& want) {
      want(DatasetEntry{0, "a"});
      want(DatasetEntry{2, "b"});
      want(DatasetEntry{5, "c"});
    });
  }
  static FinishedDemonstration finished(const std::string& name, const std::string& bytes) {
    FinishedDemonstration result;
    result.name = name;
    result.fingerprint = {"in", "con", "rob", "sce", "pro"};
    result.dataset = "data";
    result.summary.demonstrations = 1;
    result.summary.movements = 2;
    result.summary.reasons["smoothing_collision"] = 1;
    result.summary.stage_cpu_s["map"] = 0.1;
    result.plans = {{"row 1 of " + name, bytes}, {"row 2 of " + name, bytes}};
    return result;
  }
  static std::vector<std::string> plans_of(const Journal& journal, const std::string& name) {
    std::vector<std::string> all;
    journal.each_plan(
        name, [&](const FinishedDemonstration::StoredPlan& plan) { all.push_back(plan.bytes); });
    return all;
  }

  fs::path folder;
};

TEST_F(JournalTest, KeepsWhatWasCommittedAndNothingElse) {
  {
    const auto journal = open();
    begin(*journal);
    journal->add(finished("b", "first"));
    journal->add(finished("b", "second"));
    journal->commit();
    journal->add(finished("a", "lost"));
  }
  const auto journal = open();
  EXPECT_EQ(plans_of(*journal, "b"), (std::vector<std::string>{"second", std::string("second")}));
  EXPECT_FALSE(journal->find("a"));
  const std::optional<FinishedDemonstration> found = journal->find("b");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->fingerprint.input + found->fingerprint.config + found->fingerprint.robot +
                found->fingerprint.scene + found->fingerprint.program + found->dataset,
            "inconrobsceprodata");
  EXPECT_EQ(found->summary.reasons.at("smoothing_collision"), 1);
  EXPECT_EQ(found->summary.stage_cpu_s.at("map"), 0.1);
}

TEST_F(JournalTest, GoesThroughWhatIsWantedInOrder) {
  const auto journal = open();
  for (int pass = 0; pass < 2; ++pass) {
    begin(*journal);
    std::vector<std::string> names;
    std::vector<std::int64_t> positions;
    while (const std::optional<DatasetEntry> place = journal->next()) {
      names.push_back(place->name);
      positions.push_back(place->position);
    }
    EXPECT_THAT(names, ElementsAre("a", "b", "c"));
    EXPECT_THAT(positions, ElementsAre(0, 2, 5));
  }
  journal->add(finished("c", "3"));
  journal->add(finished("a", "1"));
  std::vector<std::string> rows;
  journal->each_row([&](const std::string& row) { rows.push_back(row); });
  EXPECT_THAT(rows, ElementsAre("row 1 of a", "row 2 of a", "row 1 of c", "row 2 of c"));
  EXPECT_EQ(journal->summary().movements, 4);
}

TEST_F(JournalTest, KeepsWhatTheDatasetNoLongerHasButDoesNotCountIt) {
  const auto journal = open();
  begin(*journal);
  journal->add(finished("gone", "x"));
  EXPECT_TRUE(journal->find("gone"));
  EXPECT_FALSE(journal->is_complete());
  journal->mark_complete();
  EXPECT_TRUE(journal->is_complete());
  EXPECT_TRUE(journal->find("gone"));
  EXPECT_EQ(journal->summary().demonstrations, 0);
  journal->each_result([](const std::string& name) { ADD_FAILURE() << name; });
  EXPECT_FALSE(fs::exists(folder / "journal.sqlite-wal"));
}

TEST_F(JournalTest, OfAnotherVersionOrShardIsRefusedUnlessFresh) {
  {
    const auto journal = open({2, 3});
    begin(*journal);
    journal->add(finished("a", "1"));
    journal->commit();
  }
  const auto refused = [&](const std::string& software, const Shard& shard) {
    try {
      Journal::write(folder, software, shard, false);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused("morphe 2", {2, 3}), HasSubstr("was written by morphe 1.2.3"));
  EXPECT_THAT(refused("morphe 1.2.3", {1, 3}), HasSubstr("contains shard 2/3"));
  EXPECT_EQ(refused("morphe 1.2.3", {2, 3}), "");
  EXPECT_FALSE(open({}, true)->has_results());
}

}  // namespace
}  // namespace morphe::run
