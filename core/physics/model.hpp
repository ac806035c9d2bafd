#pragma once

#include <memory>
#include <string>

#include "core/physics/engine.hpp"

struct mjModel_;  // of MuJoCo

namespace morphe::physics {

/// A model compiled from MJCF text, in SI units. It is const and shared by all threads.
class Model {
 public:
  /// Compiles a model. Throws EngineError with the engine's message, also if the engine only warns,
  /// as of invalid numbers.
  explicit Model(const std::string& mjcf);

  /// Returns the index of a named body; throws EngineError if there is no body with that name.
  int body(const std::string& name) const;
  /// Returns the index of a named joint; throws EngineError as body() does.
  int joint(const std::string& name) const;
  /// Returns the index of a named geom; throws EngineError as body() does.
  int geom(const std::string& name) const;
  /// Returns the index of a named actuator; throws EngineError as body() does.
  int actuator(const std::string& name) const;
  /// Returns the number of geoms.
  int geom_count() const;

  /// Returns MuJoCo's own model.
  const mjModel_& compiled() const { return *compiled_; }

 private:
  std::unique_ptr<mjModel_, void (*)(mjModel_*)> compiled_;
};

}  // namespace morphe::physics
