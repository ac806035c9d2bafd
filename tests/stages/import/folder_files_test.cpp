#include "stages/import/folders/folder_files.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class FolderFilesTest : public RecordingFolder {
 protected:
  /// "NAME: reason" of what was left out.
  std::vector<std::string> left_out() {
    std::vector<std::string> lines;
    for (const SkippedFile& skipped : list_files(folder_, "").left_out)
      lines.push_back(skipped.file.filename().string() + ": " + skipped.reason);
    return lines;
  }
};

TEST_F(FolderFilesTest, AFolderThatDoesNotExistIsAnError) {
  try {
    list_files(folder_ / "missing", "");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(),
              (folder_ / "missing").string() + ": cannot be read: No such file or directory");
  }
}

TEST_F(FolderFilesTest, ALinkBehindItsFolderIsSkipped) {
  fs::create_directory(folder_ / "a");
  fs::create_directory_symlink(folder_ / "a", folder_ / "b");
  EXPECT_THAT(left_out(), ElementsAre("b: link to a folder that was already searched"));
}

TEST_F(FolderFilesTest, AFolderBehindALinkToItIsSkipped) {
  fs::create_directory(folder_ / "b");
  fs::create_directory_symlink(folder_ / "b", folder_ / "a");
  EXPECT_THAT(left_out(), ElementsAre("b: folder that was already searched through a link to it"));
}

TEST_F(FolderFilesTest, ALinkOutOfTheFolderIsNotFollowed) {
  const fs::path other = folder_ / "other";
  fs::create_directories(folder_ / "own/inner");
  fs::create_directory(other);
  std::ofstream(other / "secret.csv") << "1";
  std::ofstream(folder_ / "own/kept.csv") << "1";
  fs::create_symlink(other / "secret.csv", folder_ / "own/file.csv");
  fs::create_directory_symlink(other, folder_ / "own/folder");
  fs::create_directory_symlink("/proc/self", folder_ / "own/inner/process");
  fs::create_symlink("kept.csv", folder_ / "own/same.csv");
  const FolderFiles found = list_files(folder_ / "own", "");
  EXPECT_THAT(found.files, ElementsAre(folder_ / "own/kept.csv", folder_ / "own/same.csv"));
  ASSERT_EQ(found.left_out.size(), 3);
  for (const SkippedFile& file : found.left_out) {
    EXPECT_TRUE(file.failed) << file.file;
    EXPECT_THAT(file.reason, testing::StartsWith("link out of the folder"));
  }
}

TEST_F(FolderFilesTest, AnEntryThatCannotBeReadHasTheReasonOfTheSystem) {
  fs::create_symlink(folder_ / "missing", folder_ / "broken.csv");
  fs::create_symlink(folder_ / "loop.csv", folder_ / "loop.csv");
  EXPECT_THAT(left_out(),
              ElementsAre("broken.csv: cannot be read: No such file or directory",
                          "loop.csv: cannot be read: Too many levels of symbolic links"));
}

}  // namespace
}  // namespace morphe::imports
