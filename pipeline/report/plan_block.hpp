#pragma once

#include <string>
#include <vector>

#include "pipeline/report/block.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// Steps of the tables: what is shown differs from what was computed by half of one at most.
struct Steps {
  static constexpr double kAngle = 1e-4;       ///< [rad], of sliding joints [m]
  static constexpr double kLength = 1e-5;      ///< [m]
  static constexpr double kError = 1e-6;       ///< tips' errors, clearance [m], [rad]
  static constexpr double kTime = 1e-6;        ///< [s]
  static constexpr double kShare = 1e-3;       ///< of a limit
  static constexpr double kQuaternion = 1e-5;  ///< of a unit quaternion
};

/// A plan as the page takes it (page/README.md); `object_blocks` names the mesh of each object, ""
/// of others.
Block plan_block(const robot::Robot& robot, const Plan& plan, const PlanView& view,
                 const std::vector<std::string>& object_blocks);

/// {vertices, triangles}
Block mesh_block(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles);

}  // namespace morphe::report
