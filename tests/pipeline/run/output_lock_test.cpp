#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>

#include "core/motion/input_error.hpp"
#include "pipeline/run/file_lock.hpp"
#include "pipeline/run/output_files.hpp"
#include "pipeline/run/output_folder.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kOther = ": another command is writing to it";

fs::path fresh_lock_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("output_lock_" + name);
  fs::remove_all(folder);
  return folder;
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string folder_refusal(const fs::path& folder) {
  return refusal([&] { const OutputFolder again(folder); });
}

std::string files_refusal(const std::vector<fs::path>& files) {
  return refusal([&] { const OutputFiles again(files); });
}

TEST(OutputFolder, IsHeldUntilItsEnd) {
  const fs::path folder = fresh_lock_folder("one") / "new";
  {
    OutputFolder held(folder);
    held.keep();
    EXPECT_THAT(folder_refusal(folder), HasSubstr(folder.string() + kOther));
  }
  EXPECT_FALSE(fs::exists(folder / ".lock"));
  EXPECT_EQ(folder_refusal(folder), "");
}

TEST(OutputFolder, ARefusalLeavesTheFolderOfTheOther) {
  const fs::path folder = fresh_lock_folder("refusal");
  OutputFolder held(folder);
  EXPECT_NE(folder_refusal(folder), "");
  EXPECT_TRUE(fs::is_directory(folder));
}

TEST(FileLock, AFolderThatCannotBeCreatedIsNamedWithTheReason) {
  const fs::path folder = fresh_lock_folder("file");
  fs::create_directories(folder);
  std::ofstream(folder / "text") << "not a folder";
  const fs::path inside = folder / "text" / "out";
  EXPECT_EQ(refusal([&] { const FileLock lock(inside / ".lock", inside, true); }),
            inside.string() + ": cannot be created: Not a directory");
}

TEST(FileLock, DoesNotRemoveTheLockOfAnotherProcess) {
  const fs::path folder = fresh_lock_folder("removed");
  const fs::path file = folder / ".lock";
  std::optional<FileLock> first(std::in_place, file, folder, true);
  fs::remove(file);  // by hand
  const FileLock second(file, folder, true);
  first.reset();
  EXPECT_TRUE(fs::exists(file));
  EXPECT_THAT(folder_refusal(folder), HasSubstr(kOther));
}

TEST(FileLock, AFileThatAKilledProcessHasLeftDoesNotBlock) {
  const fs::path folder = fresh_lock_folder("stale");
  fs::create_directories(folder);
  std::ofstream(folder / ".lock") << "";
  EXPECT_EQ(folder_refusal(folder), "");
}

TEST(OutputFiles, CommandsWithACommonFileExcludeEachOther) {
  const fs::path folder = fresh_lock_folder("files");
  fs::create_directories(folder);
  const fs::path a = folder / "a.yaml", b = folder / "b.svg", c = folder / "c.svg";
  {
    const OutputFiles held({b, fs::path(), a});
    EXPECT_THAT(files_refusal({a, c}), HasSubstr(a.string() + kOther));
    EXPECT_THAT(files_refusal({folder / "." / "b.svg"}), HasSubstr(kOther));
    EXPECT_EQ(files_refusal({c}), "");
  }
  EXPECT_EQ(files_refusal({a, b}), "");
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(OutputFiles, AFileIsNotNamedTwice) {
  const fs::path folder = fresh_lock_folder("twice");
  fs::create_directories(folder);
  EXPECT_THAT(files_refusal({folder / "a", folder / "." / "a"}), HasSubstr("written twice"));
}

TEST(OutputFiles, AFolderThatIsMissingIsNotCreated) {
  const fs::path file = fresh_lock_folder("missing") / "a";
  EXPECT_THAT(files_refusal({file}), HasSubstr(file.string() + ": cannot be written"));
  EXPECT_FALSE(fs::exists(file.parent_path()));
}

}  // namespace
}  // namespace morphe::run
