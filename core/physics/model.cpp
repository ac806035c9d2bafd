#include "core/physics/model.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>

#include "core/physics/engine.hpp"

namespace morphe::physics {
namespace {

constexpr const char* kFile = "model.xml";

int number_of(const Model& model, int kind, const std::string& name) {
  const int number = mj_name2id(model.compiled().model, kind, name.c_str());
  if (number < 0) throw EngineError(fmt::format("the model has no element '{}'", name));
  return number;
}

}  // namespace

Model::Model(const std::string& mjcf) : compiled_(std::make_unique<Compiled>()) {
  // Allocated on the heap, because it takes two megabytes.
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kFile, static_cast<int>(mjcf.size()) + 1);
  std::memcpy(files->filedata[0], mjcf.c_str(), mjcf.size() + 1);
  std::array<char, 1000> wrong{};
  const std::string warning = call_guarded([&] {
    compiled_->model = mj_loadXML(kFile, files.get(), wrong.data(), static_cast<int>(wrong.size()));
  });
  mj_deleteVFS(files.get());
  if (!compiled_->model) throw EngineError(wrong.data());
  if (!warning.empty()) throw EngineError(warning);
}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

int Model::body(const std::string& name) const { return number_of(*this, mjOBJ_BODY, name); }
int Model::joint(const std::string& name) const { return number_of(*this, mjOBJ_JOINT, name); }
int Model::geom(const std::string& name) const { return number_of(*this, mjOBJ_GEOM, name); }
int Model::actuator(const std::string& name) const {
  return number_of(*this, mjOBJ_ACTUATOR, name);
}
int Model::geom_count() const { return compiled_->model->ngeom; }

}  // namespace morphe::physics
