#include "pipeline/run/folder_lock.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path fresh_lock_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("folder_lock_" + name);
  fs::remove_all(folder);
  return folder;
}

std::string error_of_lock(const fs::path& folder) {
  try {
    const FolderLock lock(folder);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(FolderLock, OneProcessHoldsAFolderUntilItEnds) {
  const fs::path folder = fresh_lock_folder("one") / "new";
  {
    const FolderLock lock(folder);
    EXPECT_THAT(error_of_lock(folder), HasSubstr("another run is using this folder"));
  }
  EXPECT_FALSE(fs::exists(folder / ".lock"));
  EXPECT_EQ(error_of_lock(folder), "");
}

TEST(FolderLock, AFolderThatCannotBeCreatedIsNamedWithTheReason) {
  const fs::path folder = fresh_lock_folder("file");
  fs::create_directories(folder);
  std::ofstream(folder / "text") << "not a folder";
  const fs::path inside = folder / "text" / "out";
  EXPECT_EQ(error_of_lock(inside), inside.string() + ": cannot be created: Not a directory");
}

TEST(FolderLock, DoesNotRemoveTheLockOfAnotherProcess) {
  const fs::path folder = fresh_lock_folder("removed");
  std::optional<FolderLock> first(std::in_place, folder);
  fs::remove(folder / ".lock");  // by hand
  const FolderLock second(folder);
  first.reset();
  EXPECT_TRUE(fs::exists(folder / ".lock"));
  EXPECT_THAT(error_of_lock(folder), HasSubstr("another run is using this folder"));
}

}  // namespace
}  // namespace morphe::run
