#include "stages/import/folders/folder_files.hpp"

#include <gmock/gmock.h>

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

TEST_F(FolderFilesTest, AnEntryThatCannotBeReadHasTheReasonOfTheSystem) {
  fs::create_symlink(folder_ / "missing", folder_ / "broken.csv");
  fs::create_symlink(folder_ / "loop.csv", folder_ / "loop.csv");
  EXPECT_THAT(left_out(),
              ElementsAre("broken.csv: cannot be read: No such file or directory",
                          "loop.csv: cannot be read: Too many levels of symbolic links"));
}

}  // namespace
}  // namespace morphe::imports
