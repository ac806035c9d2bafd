#include "pipeline/planning/input_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace morphe::planning {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

/// A folder of this test with files whose texts name others by absolute paths.
class InputNamesOf : public testing::Test {
 protected:
  fs::path write(const fs::path& file, const std::string& text) const {
    fs::create_directories((folder / file).parent_path());
    std::ofstream(folder / file) << text;
    return folder / file;
  }
  static std::vector<std::string> names_of(const InputNames& names) {
    std::vector<std::string> found;
    for (const PlanFileHeader::Input& input : names.read()) found.push_back(input.path);
    return found;
  }
  fs::path folder = fs::path(testing::TempDir()) / "input_names";
};

TEST_F(InputNamesOf, AGroupIsNamedFromItsCommonFolder) {
  const fs::path config = write("me/pipelines/p.yaml", "p"), robot = write("me/robots/r.yaml", "r");
  const fs::path named = config.parent_path() / "../robots/r.yaml";
  EXPECT_THAT(names_of(InputNames({config, named, named})),
              ElementsAre("pipelines/p.yaml", "robots/r.yaml"));
}

TEST_F(InputNamesOf, AnAbsolutePathBeginsAGroupAndIsReplacedInTexts) {
  const fs::path robot = write("jane/robots/arm.yaml", "arm");
  const fs::path part = write("jane/robots/parts/hand.yaml", "hand");
  const fs::path config = write("cfg/p.yaml", "file: " + robot.string() + " # " + robot.string() +
                                                  ".bak\ndata: '" + folder.string() + "/d.h5'\n");
  InputNames names({config, robot, robot.parent_path() / "parts/hand.yaml"});
  names.hide(folder / "d.h5");
  EXPECT_THAT(names_of(names), ElementsAre("p.yaml", "arm.yaml", "parts/hand.yaml"));
  EXPECT_EQ(names.read().front().text,
            "file: arm.yaml # " + robot.string() + ".bak\ndata: 'd.h5'\n");
  EXPECT_EQ(names.without_paths("robot.file=" + robot.string(), part), "robot.file=../arm.yaml");
}

TEST_F(InputNamesOf, FilesOfOneNameAreNumbered) {
  const fs::path config = write("a/robot.yaml", "config"), robot = write("b/robot.yaml", "robot"),
                 part = write("b/hand.yaml", "hand");
  EXPECT_THAT(names_of(InputNames({config, robot, part})),
              ElementsAre("robot.yaml", "2/robot.yaml", "2/hand.yaml"));
}

}  // namespace
}  // namespace morphe::planning
