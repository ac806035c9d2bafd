#include "pipeline/run/abnormal_end.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "core/files/unfinished_path.hpp"

namespace morphe::run {
namespace {

constexpr int kAbnormalExitCode = 2;
constexpr const char* kWithoutMemory = "out of memory";

bool end_is_expected = false;

/// Removes what is unfinished, and ends the process.
[[noreturn]] void end_process() {
  try {
    files::remove_unfinished_paths();
  } catch (...) {  // its files are overwritten by the next call
  }
  ::_exit(kAbnormalExitCode);
}

[[noreturn]] void end_after_exception() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
    std::fputs("morphe: ended without an exception\n", stderr);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "morphe: %s\n", kWithoutMemory);
  } catch (const std::exception& error) {
    const bool is_thread = std::strstr(error.what(), "pthread_create") != nullptr;
    std::fprintf(stderr, "morphe: %s%s\n", error.what(),
                 is_thread ? ": give a smaller --jobs, or raise the limits of processes and memory "
                             "(ulimit -u, ulimit -v)"
                           : "");
  } catch (...) {
    std::fputs("morphe: unknown exception\n", stderr);
  }
  end_process();
}

void end_unless_expected() {
  if (end_is_expected) return;
  std::fprintf(stderr, "morphe: %s\n", kWithoutMemory);
  end_process();
}

}  // namespace

void report_abnormal_ends() {
  std::set_terminate(end_after_exception);
  std::atexit(end_unless_expected);
}

void expect_end() { end_is_expected = true; }

}  // namespace morphe::run
