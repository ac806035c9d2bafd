#include "core/files/unfinished_path.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "core/files/atomic_file.hpp"

namespace morphe::files {
namespace {

namespace fs = std::filesystem;

/// Writes file after file until another thread ends the process, as a signal does.
[[noreturn]] void write_until_the_end(const fs::path& folder, std::chrono::microseconds after) {
  std::atomic<bool> begun{false};
  std::thread([&] {
    while (!begun) std::this_thread::yield();
    std::this_thread::sleep_for(after);
    remove_unfinished_paths();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::_exit(3);
  }).detach();
  const std::string text(20000, 'x');
  try {
    for (int i = 0;; ++i) {
      write_atomically(folder / std::to_string(i), text);
      begun = true;
    }
  } catch (...) {  // the file that was taken away must not be reported
    ::_exit(4);
  }
}

TEST(UnfinishedPath, NothingUnfinishedIsLeftWhenTheProcessEndsWhileFilesAreWritten) {
  const fs::path folder = fs::path(testing::TempDir()) / "morphe_unfinished_path";
  for (int i = 0; i < 40; ++i) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_until_the_end(folder, std::chrono::microseconds(37 * i));
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    ASSERT_EQ(WEXITSTATUS(status), 3);
    int complete = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
      ASSERT_EQ(entry.path().extension(), "") << entry.path();
      ASSERT_EQ(entry.file_size(), 20000) << entry.path();
      ++complete;
    }
    ASSERT_GT(complete, 0);
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace morphe::files
