#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace morphe::physics {

/// Returns "MuJoCo 2.2.2", or "" in a build without MuJoCo, in which a Model cannot be constructed.
std::string engine_version();

/// The engine rejected a model or failed; the message is the engine's.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Calls MuJoCo such that its errors are thrown as EngineError. On an error MuJoCo would otherwise
/// write MUJOCO_LOG.TXT, wait for Enter and end the process. An error outside of such a call ends
/// the program. The handlers are global, but their messages are thread-local. An error leaves
/// `call` by longjmp, so it must not have local objects with destructors, nor call this function.
/// Returns the first warning of MuJoCo, or "".
std::string call_guarded(const std::function<void()>& call);

}  // namespace morphe::physics
