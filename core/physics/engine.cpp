#include "core/physics/engine.hpp"

#include <fmt/format.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <exception>

namespace morphe::physics {
namespace {

using Words = std::array<char, 1000>;

struct Landing {
  std::jmp_buf place;
  Words error{}, warning{};
};
thread_local Landing* t_landing = nullptr;

void copy(const char* words, Words& to) { std::snprintf(to.data(), to.size(), "%s", words); }

/// A handler that returns would let the engine run on with what it just called broken.
void take_error(const char* words) {
  if (!t_landing) std::terminate();
  copy(words, t_landing->error);
  std::longjmp(t_landing->place, 1);
}

void take_warning(const char* words) {
  if (t_landing && t_landing->warning[0] == '\0') copy(words, t_landing->warning);
}

void take_over() {
  static const bool once = [] {
    mju_user_error = take_error;
    mju_user_warning = take_warning;
    return true;
  }();
  static_cast<void>(once);
}

/// Nothing here has a destructor, and nothing is kept in a register across the jump.
[[gnu::noinline]] bool lands_well(Landing& landing, const std::function<void()>& call) {
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

std::string guarded(const std::function<void()>& call) {
  take_over();
  Landing landing;
  if (!lands_well(landing, call)) throw EngineError(landing.error.data());
  return landing.warning.data();
}

std::string engine() { return fmt::format("MuJoCo {}", mj_versionString()); }

}  // namespace morphe::physics
