#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "core/robot/standing.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "stages/map/placement.hpp"

namespace morphe::place {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = MORPHE_SOURCE_DIR;

/// Returns the text of a file without marks of comments, each run of blanks as one.
std::string words_of_file(const fs::path& file) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return std::regex_replace(text, std::regex("[\\s#]+"), " ");
}

/// Every shipped config with a placement of its own says in a comment how its base stands, and
/// the page of the step lists them.
TEST(ShippedPlacements, TheirPagesSayHowTheBaseStands) {
  const std::string page = words_of_file(kSource / "docs/steps/place.md");
  int placed = 0;
  for (const auto& entry : fs::directory_iterator(kSource / "configs/pipelines")) {
    const std::string text = words_of_file(entry.path());
    if (text.find("placement: rotation:") == std::string::npos) continue;
    const planning::LoadedConfig config = planning::load_config(entry.path());
    const std::string words = map::standing_text(config.robot, config.options.placement);
    EXPECT_THAT(text, testing::HasSubstr("he base " + words)) << entry.path();
    EXPECT_THAT(page,
                testing::HasSubstr("| `" + entry.path().stem().string() + "` | " + words + " |"));
    EXPECT_EQ(text.find("Found by morphe place") != std::string::npos,
              config.options.placement.found_by.has_value())
        << entry.path();
    ++placed;
  }
  EXPECT_EQ(placed, 9);
}

TEST(ShippedPlacements, NoArmIsTakenForABody) {
  for (const auto& entry : fs::directory_iterator(kSource / "configs/robots")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_EQ(robot::standing_of(robot::load_robot(entry.path()).table).evidence, "")
        << entry.path();
  }
}

}  // namespace
}  // namespace morphe::place
