#include "core/config/spelling_hint.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace morphe::config {
namespace {

TEST(DidYouMean, CountsInsertedDroppedChangedAndSwappedLetters) {
  EXPECT_EQ(edit_distance("starts", "starts"), 0U);
  EXPECT_EQ(edit_distance("strats", "starts"), 1U);
  EXPECT_EQ(edit_distance("star", "starts"), 2U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("Coarse-Step s", "coarse_step_s"), 0U);
}

TEST(DidYouMean, NamesTheNearestWordOnly) {
  const std::vector<std::string> words = {"seed", "scene", "segment", "map", "run"};
  EXPECT_EQ(spelling_hint("sene", words), "; did you mean 'scene'?");
  EXPECT_EQ(spelling_hint("sede", words), "; did you mean 'seed'?");
  EXPECT_EQ(spelling_hint("rnu", words), "; did you mean 'run'?");
  EXPECT_EQ(spelling_hint("robot", words), "");
  EXPECT_EQ(spelling_hint("m", words), "");
  EXPECT_EQ(spelling_hint("", words), "");
  EXPECT_EQ(spelling_hint("x", {}), "");
}

TEST(DidYouMean, LooksBesideAFileThatIsNotThere) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "did you mean";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "pa10_dlr_hit2.yaml") << "a: 1\n";
  EXPECT_EQ(file_spelling_hint(folder / "pa10_dlr_hit.yaml"),
            "; did you mean '" + (folder / "pa10_dlr_hit2.yaml").string() + "'?");
  EXPECT_EQ(file_spelling_hint(folder / "pa10_dlr_hit2.yaml"), "");
  EXPECT_EQ(file_spelling_hint(folder / "another.yaml"), "");
  EXPECT_EQ(file_spelling_hint(folder / "none/pa10_dlr_hit.yaml"), "");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace morphe::config
