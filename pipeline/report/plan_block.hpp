#pragma once

#include <string>
#include <vector>

#include "pipeline/report/block.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// The steps of the tables. A displayed value differs from the computed one by at most half a step.
struct Resolution {
  static constexpr double kAngle_rad = 1e-4;   ///< angles [rad], positions of sliding joints [m]
  static constexpr double kLength_m = 1e-5;    ///< lengths [m]
  static constexpr double kError = 1e-6;       ///< position errors and distances [m], speeds [m/s]
  static constexpr double kTime_s = 1e-6;      ///< times [s]
  static constexpr double kLimitRatio = 1e-3;  ///< ratio to a limit
  static constexpr double kQuaternion = 1e-5;  ///< components of a unit quaternion
};

/// Builds the block of a plan in the format of the page (page/README.md). `object_blocks` are the
/// names of the mesh blocks of the scene's objects, in their order, "" for objects without one.
Block plan_block(const robot::Robot& robot, const Plan& plan, const PlanView& view,
                 const std::vector<std::string>& object_blocks);

/// Builds the block {vertices, triangles} of a mesh.
Block mesh_block(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles);

}  // namespace morphe::report
