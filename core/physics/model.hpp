#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace morphe::physics {

/// Returns "MuJoCo 2.2.2", or "" in a build without MuJoCo, in which a Model cannot be constructed.
std::string engine_version();

/// The engine rejected a model or failed; the message is the engine's.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A model compiled from MJCF text; it is const and shared by all threads. SI units, radians.
class Model {
 public:
  /// Compiles a model. Throws EngineError with the error and its line in the text, also for
  /// problems of which the engine only warns, such as invalid numbers.
  explicit Model(const std::string& mjcf);
  ~Model();
  Model(Model&&) noexcept;

  /// Returns the index of a named body; throws EngineError if there is no body with that name.
  int body(const std::string& name) const;
  /// Returns the index of a named joint; throws EngineError if there is no joint with that name.
  int joint(const std::string& name) const;
  /// Returns the index of a named geom; throws EngineError if there is no geom with that name.
  int geom(const std::string& name) const;
  /// Returns the index of a named actuator; throws EngineError if there is no actuator with that
  /// name.
  int actuator(const std::string& name) const;
  /// Returns the number of geoms.
  int geom_count() const;

  struct Compiled;
  /// Returns the compiled model.
  const Compiled& compiled() const { return *compiled_; }

 private:
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace morphe::physics
