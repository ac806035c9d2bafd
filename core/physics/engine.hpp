#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <string>

#include "core/physics/model.hpp"

namespace morphe::physics {

/// Owns an mjModel.
struct Model::Compiled {
  mjModel* model = nullptr;
  ~Compiled() {
    if (model) mj_deleteModel(model);
  }
};

/// Calls MuJoCo such that its errors are thrown as EngineError. By default, MuJoCo writes
/// MUJOCO_LOG.TXT, waits for Enter and ends the process on errors. The error handlers are global,
/// but their messages are thread-local. `call` may be left by longjmp, so it must not have local
/// objects with destructors. Returns the first warning of MuJoCo, "" if there is no warning.
std::string call_guarded(const std::function<void()>& call);

}  // namespace morphe::physics
