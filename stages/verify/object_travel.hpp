#pragma once

#include <vector>

#include "core/motion/scene.hpp"

namespace morphe::verify {

/// The greatest distance that any point of an object has travelled since the object's first sample.
struct ObjectTravel {
  const SceneObject* object = nullptr;
  std::vector<double> travelled;  ///< [K] at the object's samples [m]

  /// Returns the distance until a demonstration time [m].
  double until(double time_s) const;
};

/// Computes the distances along the recorded poses. The object must outlive the result.
ObjectTravel object_travel(const SceneObject& object);

}  // namespace morphe::verify
