#include "core/config/did_you_mean.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace morphe::config {
namespace {

TEST(DidYouMean, CountsInsertedDroppedChangedAndSwappedLetters) {
  EXPECT_EQ(edits_between("starts", "starts"), 0U);
  EXPECT_EQ(edits_between("strats", "starts"), 1U);
  EXPECT_EQ(edits_between("star", "starts"), 2U);
  EXPECT_EQ(edits_between("kitten", "sitting"), 3U);
  EXPECT_EQ(edits_between("", "abc"), 3U);
  EXPECT_EQ(edits_between("Coarse-Step s", "coarse_step_s"), 0U);
}

TEST(DidYouMean, NamesTheNearestWordOnly) {
  const std::vector<std::string> words = {"seed", "scene", "segment", "map", "run"};
  EXPECT_EQ(did_you_mean("sene", words), "; did you mean 'scene'?");
  EXPECT_EQ(did_you_mean("sede", words), "; did you mean 'seed'?");
  EXPECT_EQ(did_you_mean("rnu", words), "; did you mean 'run'?");
  EXPECT_EQ(did_you_mean("robot", words), "");
  EXPECT_EQ(did_you_mean("m", words), "");
  EXPECT_EQ(did_you_mean("", words), "");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(DidYouMean, LooksBesideAFileThatIsNotThere) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "did you mean";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "pa10_dlr_hit2.yaml") << "a: 1\n";
  EXPECT_EQ(did_you_mean_file(folder / "pa10_dlr_hit.yaml"),
            "; did you mean '" + (folder / "pa10_dlr_hit2.yaml").string() + "'?");
  EXPECT_EQ(did_you_mean_file(folder / "pa10_dlr_hit2.yaml"), "");
  EXPECT_EQ(did_you_mean_file(folder / "another.yaml"), "");
  EXPECT_EQ(did_you_mean_file(folder / "none/pa10_dlr_hit.yaml"), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace morphe::config
