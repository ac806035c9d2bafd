#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/motion/geometry.hpp"

namespace morphe::report {

/// Returns [x, y, z].
inline nlohmann::ordered_json point_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Returns the 16 numbers of a pose, row by row.
inline nlohmann::ordered_json pose_json(const Pose& pose) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index col = 0; col < 4; ++col) out.push_back(pose.matrix()(row, col));
  }
  return out;
}

/// Returns the number, or null if it is not finite.
inline nlohmann::ordered_json number_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

}  // namespace morphe::report
