#include "stages/export/table/plan_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "stages/export/table/dataset_card.hpp"

namespace morphe::exports {
namespace {

Plan plan_with_odd_texts() {
  Plan plan;
  plan.demonstration = "a,\"b\"";
  plan.subject = "P1";
  plan.source = "a | b";
  plan.licence = "MIT";
  plan.reason = Reason::no_path;
  plan.detail = "two\nlines";
  return plan;
}

TEST(PlanTable, EveryColumnHasAUnitOrNone) {
  std::set<std::string_view> names;
  for (const PlanColumn& column : plan_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    const bool number =
        column.type == parquet::ValueType::float64 || column.type == parquet::ValueType::int64;
    EXPECT_EQ(column.unit.empty(), !number) << column.name;
  }
}

TEST(PlanTable, CsvQuotesTextsAndLeavesTheUnknownEmpty) {
  const RobotModel robot;
  const Plan plan = plan_with_odd_texts();
  const std::string row = table_csv_row({robot, plan, ""});
  EXPECT_TRUE(
      row.starts_with("\"a,\"\"b\"\"/000\",\"a,\"\"b\"\"\",0,P1,,right,,,a | b,MIT,,"
                      "infeasible,no_path,\"two\nlines\",,,"))
      << row;
  EXPECT_EQ(row.find("nan"), std::string::npos);
}

TEST(DatasetCard, CountsAndEscapes) {
  PlanCounts counts;
  Plan plan = plan_with_odd_texts();
  counts.add(plan);
  plan.reason = Reason::none;
  counts.add(plan);
  counts.add_chosen(plan, kTrain);
  PlanFileHeader header;
  header.config = "seed: 7\n";
  header.software = "morphe <b>";
  RobotModel robot;
  robot.name = "arm";
  const std::string card = dataset_card(
      counts, {"Title", "", "Content.\n", "tempo < 2", {SplitBy::person, 0.2}, ""}, header, robot);
  using testing::HasSubstr;
  EXPECT_THAT(card, HasSubstr("2 movements planned: 1 executable (50.0 %), 1 infeasible (50.0 %)"));
  EXPECT_THAT(card, HasSubstr("| `no_path` | 1 |"));
  EXPECT_THAT(card, HasSubstr("| a \\| b | MIT | 1 |"));
  EXPECT_THAT(card, HasSubstr("| seed of the config | 7 |"));
  EXPECT_THAT(card, HasSubstr("| morphe \\<b\\> |"));
  EXPECT_THAT(card, HasSubstr("| only plans with | tempo \\< 2 |"));
  EXPECT_THAT(card, HasSubstr("About 20 % are for validation"));
  EXPECT_THAT(card, HasSubstr("| verified | yes"));
}

TEST(DatasetCard, SaysThatPlansWereNotVerified) {
  PlanCounts counts;
  counts.add(plan_with_odd_texts());
  const std::string card =
      dataset_card(counts, {"Title", "", "", "", {}, "was not verified"}, {}, {});
  EXPECT_THAT(card, testing::HasSubstr("| verified | **no**: was not verified |"));
}

}  // namespace
}  // namespace morphe::exports
