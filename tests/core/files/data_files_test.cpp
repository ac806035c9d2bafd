#include "core/files/data_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace morphe::files {
namespace {

namespace fs = std::filesystem;

struct Shipped : testing::Test {
  void SetUp() override {
    folder = fs::path(testing::TempDir()) / ("morphe_shipped_" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder / "share/configs");
    fs::create_directories(folder / "here/configs");
    before = fs::current_path();
    fs::current_path(folder / "here");
    std::ofstream(folder / "share/configs/both.yaml") << "shipped";
    std::ofstream(folder / "share/configs/shipped.yaml") << "shipped";
    std::ofstream("configs/both.yaml") << "here";
    std::ofstream("configs/here.yaml") << "here";
  }
  void TearDown() override {
    fs::current_path(before);
    fs::remove_all(folder);
  }
  fs::path find(const fs::path& named) const { return resolve_data_file(named, folder / "share"); }
  fs::path folder, before;
};

TEST_F(Shipped, WhatIsHereComesFirst) {
  EXPECT_EQ(find("configs/both.yaml"), "configs/both.yaml");
  EXPECT_EQ(find("configs/here.yaml"), "configs/here.yaml");
}

TEST_F(Shipped, WhatIsNotHereIsFoundAmongTheShipped) {
  EXPECT_EQ(find("configs/shipped.yaml"), folder / "share/configs/shipped.yaml");
}

TEST_F(Shipped, WhatIsNowhereIsLookedForWhereItsFolderIs) {
  fs::create_directories(folder / "share/studies");
  EXPECT_EQ(find("studies/none.yaml"), folder / "share/studies/none.yaml");
  EXPECT_EQ(find("configs/none.yaml"), "configs/none.yaml");
  EXPECT_EQ(find("none.yaml"), "none.yaml");
  EXPECT_EQ(find("no/folder/none.yaml"), "no/folder/none.yaml");
}

TEST_F(Shipped, AbsoluteNamesAndThoseWithoutAnInstallationStayAsTheyAre) {
  EXPECT_EQ(find("/configs/shipped.yaml"), "/configs/shipped.yaml");
  EXPECT_EQ(resolve_data_file("configs/shipped.yaml", ""), "configs/shipped.yaml");
}

}  // namespace
}  // namespace morphe::files
