#include "core/files/given_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

GivenFiles some_files() {
  GivenFiles files("/inputs");
  files.add("pipelines/a.yaml", "a");
  files.add("robots/arm.yaml", "arm");
  files.add("2/robots/arm.yaml", std::string("\0second", 7));
  files.add("mesh.stl", "");
  return files;
}

TEST(GivenFiles, AreFoundByTheirPath) {
  const GivenFiles files = some_files();
  EXPECT_EQ(files.bytes("/inputs/robots/arm.yaml"), "arm");
  EXPECT_EQ(files.bytes("robots/arm.yaml"), "arm");
  EXPECT_EQ(files.bytes("/inputs/pipelines/../2/robots/arm.yaml"), std::string("\0second", 7));
  EXPECT_EQ(files.bytes("/inputs/mesh.stl"), "");
}

TEST(GivenFiles, AreFoundByTheirNameIfTheyLostTheirFolder) {
  const GivenFiles files = some_files();
  EXPECT_EQ(files.locate("/elsewhere/robots/arm.yaml"), "/inputs/robots/arm.yaml");
  EXPECT_EQ(files.locate("/2/robots/arm.yaml"), "/inputs/2/robots/arm.yaml");
  EXPECT_EQ(files.locate("/inputs/pipelines/../../meshes/mesh.stl"), "/inputs/mesh.stl");
}

TEST(GivenFiles, TheDiskIsNotReadInTheirPlace) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "on_disk.yaml";
  std::ofstream(file) << "text";
  EXPECT_EQ(read_bytes(file), "text");
  const GivenFiles files = some_files();
  EXPECT_FALSE(is_readable_file(file, &files));
  EXPECT_THAT([&] { read_bytes(file, &files); },
              ThrowsMessage<InputError>(StrEq("/inputs: does not contain " + file.string())));
  EXPECT_THAT([&] { located("/inputs/pipelines/b.yaml", &files); },
              ThrowsMessage<InputError>(StrEq("/inputs: does not contain pipelines/b.yaml")));
}

TEST(GivenFiles, RefusesPathsThatLeaveTheFolderOrAppearTwice) {
  GivenFiles files = some_files();
  const auto add = [&](const char* path) { return [&files, path] { files.add(path, ""); }; };
  EXPECT_THAT(add("../a.yaml"),
              ThrowsMessage<InputError>(StrEq("/inputs/../a.yaml: is outside of /inputs")));
  EXPECT_THROW(add("/etc/passwd")(), InputError);
  EXPECT_THROW(add("robots/..")(), InputError);
  EXPECT_THAT(add("robots/./arm.yaml"),
              ThrowsMessage<InputError>(StrEq("/inputs/robots/arm.yaml: appears twice")));
}

}  // namespace
}  // namespace morphe::files
