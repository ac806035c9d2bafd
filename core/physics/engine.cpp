#include "core/physics/engine.hpp"

#include <fmt/format.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <exception>

namespace morphe::physics {
namespace {

using Message = std::array<char, 1000>;

struct JumpTarget {
  std::jmp_buf place;
  Message error{}, warning{};
};
thread_local JumpTarget* t_landing = nullptr;

void copy(const char* words, Message& to) { std::snprintf(to.data(), to.size(), "%s", words); }

/// Jumps out of the engine, which would otherwise continue in an invalid state.
void on_error(const char* words) {
  if (!t_landing) std::terminate();
  copy(words, t_landing->error);
  std::longjmp(t_landing->place, 1);
}

void on_warning(const char* words) {
  if (t_landing && t_landing->warning[0] == '\0') copy(words, t_landing->warning);
}

void install_handlers() {
  static const bool once = [] {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    return true;
  }();
  static_cast<void>(once);
}

/// This function has no objects with destructors, and no value that is kept in a register across
/// the jump.
[[gnu::noinline]] bool call_with_jump(JumpTarget& landing, const std::function<void()>& call) {
  t_landing = &landing;
  if (setjmp(landing.place) != 0) {
    t_landing = nullptr;
    return false;
  }
  call();
  t_landing = nullptr;
  return true;
}

}  // namespace

std::string call_guarded(const std::function<void()>& call) {
  install_handlers();
  JumpTarget landing;
  if (!call_with_jump(landing, call)) throw EngineError(landing.error.data());
  return landing.warning.data();
}

std::string engine_version() { return fmt::format("MuJoCo {}", mj_versionString()); }

}  // namespace morphe::physics
