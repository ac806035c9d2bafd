#pragma once

#include <mujoco/mujoco.h>

#include <functional>
#include <string>

#include "core/physics/model.hpp"

namespace morphe::physics {

/// mjModel, freed with it.
struct Model::Compiled {
  mjModel* model = nullptr;
  ~Compiled() {
    if (model) mj_deleteModel(model);
  }
};

/// Calls into MuJoCo so that its errors end here, as EngineError: left to itself it writes
/// MUJOCO_LOG.TXT, waits for Enter and ends the process. Its handlers are the process's, what they
/// note is the thread's. `call` is left by a jump: nothing in it may have a destructor.
/// Returns what MuJoCo warned of meanwhile, "" if of nothing.
std::string guarded(const std::function<void()>& call);

}  // namespace morphe::physics
