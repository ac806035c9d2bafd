#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/explain/advice.hpp"
#include "pipeline/report/display_motion.hpp"
#include "pipeline/report/worst_instant.hpp"

namespace morphe::report {

/// The displayed data of a plan, computed from its file by the functions with which it was planned.
struct PlanView {
  /// The pose of the base in the world: X to the person's right, Y forward, Z up. Its origin is the
  /// person's first known shoulder of the movement, or that of the base if no shoulder is known.
  Pose world_from_base = Pose::Identity();
  bool upright = false;                ///< false if the rotation is unknown, and identity
  std::vector<DisplayMotion> motions;  ///< in the order in which they are played
  std::vector<double> human_speed;     ///< [F] mean speed of the tips' goals [m/s]; NaN: unknown
  std::optional<WorstInstant> worst;   ///< of an infeasible plan
  std::vector<std::string> advice;     ///< for an infeasible plan
};

/// Computes the displayed data of a plan. `world_from_base` and `context` are those of the
/// OpenedRun.
PlanView make_plan_view(const robot::Robot& robot,
                        const std::optional<Eigen::Matrix3d>& world_from_base, const Plan& plan,
                        const explain::AdviceContext& context = {});

/// Returns the human's point for a goal of the arm, by removing the common base offset.
Vec3 without_common_offset(const Goals& goals, const Vec3& in_common_base);

}  // namespace morphe::report
