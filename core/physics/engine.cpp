#include "core/physics/engine.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <exception>

namespace morphe::physics {
namespace {

using MessageBuffer = std::array<char, 1000>;

/// The place to which an error jumps, and the messages of the call.
struct JumpTarget {
  std::jmp_buf place;
  MessageBuffer error{}, warning{};
};
thread_local JumpTarget* t_target = nullptr;  ///< null outside of a call

void copy(const char* text, MessageBuffer& message) {
  std::snprintf(message.data(), message.size(), "%s", text);
}

/// Jumps out of the engine, which would otherwise continue in an invalid state.
void on_error(const char* text) {
  if (!t_target) std::terminate();
  copy(text, t_target->error);
  std::longjmp(t_target->place, 1);
}

void on_warning(const char* text) {
  if (t_target && t_target->warning[0] == '\0') copy(text, t_target->warning);
}

/// Returns false if the call ended in an error. It is a function of its own because of the jump: it
/// has no objects with destructors, and keeps no value in a register across the jump.
[[gnu::noinline]] bool call_with_jump(JumpTarget& target, const std::function<void()>& call) {
  t_target = &target;
  if (setjmp(target.place) != 0) {
    t_target = nullptr;
    return false;
  }
  call();
  t_target = nullptr;
  return true;
}

}  // namespace

std::string call_guarded(const std::function<void()>& call) {
  [[maybe_unused]] static const bool installed = [] {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    return true;
  }();
  JumpTarget target;
  if (!call_with_jump(target, call)) throw EngineError(target.error.data());
  return target.warning.data();
}

std::string engine_version() { return fmt::format("MuJoCo {}", mj_versionString()); }

}  // namespace morphe::physics
