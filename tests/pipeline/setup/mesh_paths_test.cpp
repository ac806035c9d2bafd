#include "pipeline/setup/mesh_paths.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;

/// A folder of packages with a URDF, in which a test puts empty files.
class MeshPaths : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            testing::UnitTest::GetInstance()->current_test_info()->name();
    urdf_ = root_ / "ws/robot/urdf/arm.urdf";
  }
  fs::path put(const std::string& name) {
    const fs::path file = root_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
    return file;
  }
  MeshPlace find(const std::string& name, const PackagePaths& places = {}) {
    return find_mesh(urdf_, name, places);
  }
  fs::path root_, urdf_;
};

TEST_F(MeshPaths, OfPackagesAreSearchedInTheFoldersAbove) {
  for (const char* place : {"ws/foo", "ws/src/foo", "ws/share/foo", "ws/robot"}) {
    const fs::path file = put(std::string(place) + "/meshes/a.stl");
    for (const char* name : {"package://foo/meshes/a.stl", "model://foo/meshes/a.stl",
                             "$(find foo)/meshes/a.stl", "package://foo\\meshes\\a.stl"}) {
      EXPECT_EQ(find(name).file, file) << name;
      EXPECT_EQ(find(name).package, "foo") << name;
      EXPECT_FALSE(find(name).by_tail) << name;
    }
    fs::remove(file);
  }
}

TEST_F(MeshPaths, TheNearestFolderAndTheLongestEndWin) {
  put("ws/foo/meshes/a.stl");
  const fs::path nearest = put("ws/robot/foo/meshes/a.stl");
  EXPECT_EQ(find("package://foo/meshes/a.stl").file, nearest);
  put("ws/robot/urdf/a.stl");
  const fs::path longest = put("ws/visual/a.stl");
  EXPECT_EQ(find("package://bar/meshes/visual/a.stl").file, longest);
  EXPECT_TRUE(find("package://bar/meshes/visual/a.stl").by_tail);
}

TEST_F(MeshPaths, OfAGivenPackageAreSearchedThereAlone) {
  put("ws/foo/meshes/a.stl");
  const fs::path given = put("elsewhere/meshes/b.stl");
  const PackagePaths places{{{"foo", root_ / "elsewhere"}}};
  EXPECT_EQ(find("package://foo/meshes/b.stl", places).file, given);
  EXPECT_EQ(find("package://foo/deep/meshes/b.stl", places).file, given);
  EXPECT_TRUE(find("package://foo/meshes/a.stl", places).file.empty());
}

TEST_F(MeshPaths, WithoutAPackageBeginAtTheUrdf) {
  const fs::path file = put("ws/robot/meshes/a.stl");
  put("ws/robot/urdf/x");
  EXPECT_TRUE(fs::equivalent(find("../meshes/a.stl").file, file));
  EXPECT_EQ(find(file.string()).file, file);
  EXPECT_EQ(find("file://" + file.string()).file, file);
  EXPECT_EQ(find("/home/nobody/robot/meshes/a.stl").file, file);  // of another machine
  EXPECT_TRUE(find("/home/nobody/robot/meshes/a.stl").by_tail);
  for (const char* name : {"", "package://", "package://foo", "package://foo/", "..", "/"})
    EXPECT_TRUE(find(name).file.empty()) << name;
}

}  // namespace
}  // namespace morphe::setup
