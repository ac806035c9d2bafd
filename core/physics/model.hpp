#pragma once

#include <memory>
#include <stdexcept>
#include <string>

namespace morphe::physics {

/// "MuJoCo 2.2.2"; "" in a build without it: there no Model can be made.
std::string engine();

/// The engine refused a model, or gave up: its own words.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A model made of MJCF text; const, and shared by all threads. SI units, radians.
class Model {
 public:
  /// EngineError: what is wrong and in which line of the text; also for what the engine itself
  /// would only warn of, such as a number that is none.
  explicit Model(const std::string& mjcf);
  ~Model();
  Model(Model&&) noexcept;

  /// Numbers of what has a name. EngineError: there is none of that name.
  int body(const std::string& name) const;
  int joint(const std::string& name) const;
  int geom(const std::string& name) const;
  int actuator(const std::string& name) const;
  int geom_count() const;

  struct Compiled;  ///< engine.hpp
  const Compiled& compiled() const { return *compiled_; }

 private:
  std::unique_ptr<Compiled> compiled_;
};

}  // namespace morphe::physics
