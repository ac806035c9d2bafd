#include "stages/import/folders/static_pairing.hpp"

#include <gtest/gtest.h>

#include "stages/import/folders/folder_files.hpp"

namespace morphe::imports {
namespace {

RecordingDescriptor sketch(const std::string& path,
                           std::vector<std::string> points = {"A", "B", "C"},
                           const std::string& subject = "") {
  const std::filesystem::path file(path);
  RecordingDescriptor sketch;
  sketch.folders = folder_names(file.parent_path());
  sketch.stem = file.stem().string();
  sketch.format = file.extension().string();
  sketch.points = std::move(points);
  sketch.subject = subject;
  return sketch;
}

/// The stems and folders of the static trials that recordings get, "-" for none.
std::vector<std::string> paired(const std::vector<std::string>& recordings,
                                const std::vector<std::string>& statics) {
  std::vector<RecordingDescriptor> trials, still;
  for (const std::string& path : recordings) trials.push_back(sketch(path));
  for (const std::string& path : statics) still.push_back(sketch(path));
  std::vector<std::string> result;
  for (const auto& pair : pair_static_trials(trials, still)) {
    result.push_back(pair ? statics[pair->static_index] : "-");
  }
  return result;
}

using Paths = std::vector<std::string>;

TEST(StaticPairing, AFolderAPerson) {
  EXPECT_EQ(paired({"P01/t1.csv", "P02/t1.csv", "P03/t1.csv"}, {"P01/static.csv", "P02/cal.csv"}),
            (Paths{"P01/static.csv", "P02/cal.csv", "-"}));
}

TEST(StaticPairing, OneFolderForAll) {
  EXPECT_EQ(paired({"ADL001DR2.csv", "ADL010DR2.csv", "ADL1000DR2.csv", "ADL002DR2.csv"},
                   {"ADL001_static.csv", "ADL010_static.csv", "ADL099_static.csv"}),
            (Paths{"ADL001_static.csv", "ADL010_static.csv", "-", "-"}));
  EXPECT_EQ(
      paired({"anna_1.csv", "bert_1.csv", "carl_1.csv"}, {"anna_static.csv", "static_bert.csv"}),
      (Paths{"anna_static.csv", "static_bert.csv", "-"}));
}

TEST(StaticPairing, SessionsAndTheFolderAbove) {
  EXPECT_EQ(paired({"P01/s1/t1.csv", "P01/s2/t1.csv", "P02/s1/t1.csv"},
                   {"P01/s1/static.csv", "P01/static.csv", "P02/s2/static.csv"}),
            (Paths{"P01/s1/static.csv", "P01/static.csv", "-"}));
  EXPECT_EQ(paired({"P01_s1_a.csv", "P01_s2_a.csv"}, {"P01_s1_static.csv", "P01_s2_static.csv"}),
            (Paths{"P01_s1_static.csv", "P01_s2_static.csv"}));
}

TEST(StaticPairing, FoldersOfStaticTrials) {
  EXPECT_EQ(paired({"P01/dynamic/t1.csv", "P01/dynamic/t2.csv", "P02/dynamic/t1.csv"},
                   {"P01/Static/t1.csv", "P02/calib/x.csv"}),
            (Paths{"P01/Static/t1.csv", "P01/Static/t1.csv", "P02/calib/x.csv"}));
  EXPECT_EQ(paired({"reach/P1/t1.csv", "reach/P2/t1.csv", "reach/P3/t1.csv"},
                   {"static/P1/t.csv", "static/P2.csv"}),
            (Paths{"static/P1/t.csv", "static/P2.csv", "-"}));
  EXPECT_EQ(
      paired({"reach/P01_a.csv", "reach/P02_a.csv"}, {"calib/day1/P01.csv", "calib/day1/P02.csv"}),
      (Paths{"calib/day1/P01.csv", "calib/day1/P02.csv"}));
}

TEST(StaticPairing, NumbersOfTrialsAreNobodys) {
  EXPECT_EQ(paired({"P01/Trial02.csv", "P01/Trial03.csv"}, {"P01/Trial01 static.csv"}),
            (Paths{"P01/Trial01 static.csv", "P01/Trial01 static.csv"}));
  EXPECT_EQ(paired({"P01/02_reach.csv", "P01/reach01.csv"}, {"P01/Static 01.csv"}),
            (Paths{"P01/Static 01.csv", "P01/Static 01.csv"}));
}

TEST(StaticPairing, OfSeveralTheOneWithMostMarkersInCommon) {
  const std::vector<RecordingDescriptor> trials = {sketch("P1/a.csv", {"A", "B", "C", "D"}),
                                                   sketch("P1/b.csv", {"E", "F", "G"})};
  const std::vector<RecordingDescriptor> statics = {sketch("P1/static1.csv", {"A", "B", "C"}),
                                                    sketch("P1/static2.csv", {"A", "B", "C", "D"}),
                                                    sketch("P1/static3.csv", {"E", "F", "G"})};
  const auto pairs = pair_static_trials(trials, statics);
  ASSERT_TRUE(pairs[0] && pairs[1]);
  EXPECT_EQ(pairs[0]->static_index, 1u);
  EXPECT_EQ(pairs[0]->candidate_count, 2u);
  EXPECT_EQ(pairs[1]->static_index, 2u);
}

TEST(StaticPairing, TheSubjectInTheFileDecidesWhereNoNameDoes) {
  const std::vector<RecordingDescriptor> trials = {sketch("x.csv", {"A", "B", "C"}, "bert")};
  const auto pairs = pair_static_trials(trials, {sketch("static1.csv", {"A", "B", "C"}, "anna"),
                                                 sketch("static2.csv", {"A", "B", "C"}, "bert")});
  ASSERT_TRUE(pairs[0]);
  EXPECT_EQ(pairs[0]->static_index, 1u);
}

TEST(StaticPairing, NeverOfAnotherFormatOrWithoutMarkersInCommon) {
  EXPECT_EQ(paired({"P01/t1.csv"}, {"P01/static.c3d"}), (Paths{"-"}));
  EXPECT_FALSE(pair_static_trials({sketch("a.csv")}, {sketch("static.csv", {"X", "Y", "Z"})})[0]);
}

TEST(StaticPairing, ThePersonAsTheNameWritesIt) {
  const auto pairs = pair_static_trials(
      {sketch("ADL001DR2.csv"), sketch("reach/Käthe 2/x.csv")},
      {sketch("ADL001_static.csv"), sketch("static/kÄthe 02.csv"), sketch("static/Käthe 02.csv")});
  EXPECT_EQ(pairs[0]->person, "ADL001");
  ASSERT_TRUE(pairs[1]);
  EXPECT_EQ(pairs[1]->person, "Käthe 2");
  EXPECT_EQ(pairs[1]->static_index, 2u);
}

}  // namespace
}  // namespace morphe::imports
