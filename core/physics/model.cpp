#include "core/physics/model.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>

namespace morphe::physics {
namespace {

constexpr const char* kFile = "model.xml";  ///< in the virtual file system of one model

int index_of(const Model& model, int kind, const std::string& name) {
  const int index = mj_name2id(&model.compiled(), kind, name.c_str());
  if (index < 0) throw EngineError(fmt::format("the model has no element '{}'", name));
  return index;
}

}  // namespace

Model::Model(const std::string& mjcf) : compiled_(nullptr, mj_deleteModel) {
  const auto files = std::make_unique<mjVFS>();  // two megabytes, too many for the stack
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kFile, static_cast<int>(mjcf.size()) + 1);
  std::memcpy(files->filedata[0], mjcf.c_str(), mjcf.size() + 1);
  std::array<char, 1000> error{};
  const std::string warning = call_guarded(
      [&] { compiled_.reset(mj_loadXML(kFile, files.get(), error.data(), error.size())); });
  mj_deleteVFS(files.get());
  if (!compiled_) throw EngineError(error.data());
  if (!warning.empty()) throw EngineError(warning);
}

int Model::body(const std::string& name) const { return index_of(*this, mjOBJ_BODY, name); }
int Model::joint(const std::string& name) const { return index_of(*this, mjOBJ_JOINT, name); }
int Model::geom(const std::string& name) const { return index_of(*this, mjOBJ_GEOM, name); }
int Model::actuator(const std::string& name) const { return index_of(*this, mjOBJ_ACTUATOR, name); }
int Model::geom_count() const { return compiled_->ngeom; }

}  // namespace morphe::physics
