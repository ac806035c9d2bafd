#include "core/files/read_in_child.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "core/files/sandbox.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// How a child that does `what` ended, as waitpid() has it.
template <class What>
int child(const What& what) {
  const pid_t id = ::fork();
  if (id == 0) ::_exit(what());
  int status = -1;
  ::waitpid(id, &status, 0);
  return status;
}

TEST(Confine, ReadsAndDoesNothingElse) {
  const fs::path file = fs::path(testing::TempDir()) / "morphe_confine";
  const fs::path other = fs::path(testing::TempDir()) / "morphe_confine_other";
  std::ofstream(file) << "text";
  const int status = child([&] {
    enter_read_sandbox(10, std::uint64_t{1} << 30);
    char byte = 0;
    const int read = ::open(file.c_str(), O_RDONLY);
    if (read < 0 || ::read(read, &byte, 1) != 1 || byte != 't') return 1;
    if (::open(other.c_str(), O_WRONLY | O_CREAT, 0600) >= 0) return 2;
    if (::open(file.c_str(), O_RDWR) >= 0) return 3;
    if (::unlink(file.c_str()) == 0) return 4;
    if (::socket(AF_INET, SOCK_STREAM, 0) >= 0) return 5;
    if (::fork() >= 0) return 6;
    return 0;
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(fs::file_size(file), 4u);
  EXPECT_FALSE(std::filesystem::exists(other));
}

TEST(Confine, WhatDoesNotEndIsEnded) {
  const int status = child([] {
    enter_read_sandbox(1, std::uint64_t{1} << 30);
    volatile unsigned long count = 0;
    while (true) count = count + 1;
    return 0;
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGXCPU);
}

TEST(ReadInChild, SaysHowItEnded) {
  const fs::path file = fs::path(testing::TempDir()) / "morphe_in_child";
  std::ofstream(file) << "text";
  EXPECT_EQ(child_read_error(file, [] {}), "");
  EXPECT_EQ(child_read_error(file, [] { throw InputError("is for its reader"); }), "");
  EXPECT_EQ(child_read_error(file, [] { throw std::runtime_error("of a library"); }),
            "the library that reads it fails");
  const auto crash = [] {
    volatile int* volatile nowhere = nullptr;
    *nowhere = 1;
  };
  EXPECT_THAT(child_read_error(file, crash), HasSubstr("the library that reads it"));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_EQ(child_read_error(file, [] { std::vector<char>(std::size_t{3} << 30).back() = 1; }),
            "reading it takes more than 1024 MB of memory");
#endif
  fs::remove(file);
}

}  // namespace
}  // namespace morphe::files
