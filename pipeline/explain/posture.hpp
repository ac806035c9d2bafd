#pragma once

#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/explain/palm_floor.hpp"

namespace morphe::explain {

/// The distance of the driven wrist from the place at which both links would have the person's
/// directions, over the samples (humanlike::wrist_offset), and how much of it two changes would
/// remove, one after the other, without regard to reach, joint limits and obstacles.
struct WristOffset {
  double rms = kUnknown;              ///< [m]
  Vec3 base_shift = unknown_point();  ///< the shift of the base that removes most, base frame [m]
  double after_shift = kUnknown;      ///< RMS that remains after it [m]
  double upper_arm = kUnknown, forearm = kUnknown;  ///< the robot's lengths, means [m]
  double best_scale = kUnknown;   ///< of both lengths, that removes most of the rest
  double after_scale = kUnknown;  ///< RMS that remains after both changes [m]
};

/// The cause of a figure of posture, by the rule of docs/steps/explain.md: `small` below 6
/// degrees; of the wrist's offset, `placement` what a shift of the base removes, `size` what links
/// of another size remove of the rest, `wrist_path` what remains; of the palm's angle, `robot_hand`
/// what the fingers force, `placement_or_size` what the arm forces; `weights_or_solver`: what the
/// same wrist, or the same tips, would not need.
enum class FigureCause {
  unknown,
  small,
  placement,
  size,
  wrist_path,
  robot_hand,
  placement_or_size,
  weights_or_solver
};
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 8> names_of(FigureCause) {
  return {"unknown",    "small",      "placement",         "size",
          "wrist_path", "robot_hand", "placement_or_size", "weights_or_solver"};
}

/// A figure of the driven posture, the least that the same wrist or tips would allow, both means
/// over the samples [rad], and the cause.
struct PostureFigure {
  double driven = kUnknown, least = kUnknown;
  FigureCause cause = FigureCause::unknown;
};

/// The posture of a trajectory against the person's.
struct PostureSummary {
  bool has_elbow_circle = false;  ///< whether the robot can turn its elbow at a given wrist
  PostureFigure upper_arm, forearm, swivel, palm;
  WristOffset wrist;
  PalmFloor palm_floor;
};
/// Computes the summary; all is unknown without a trajectory, or for a hand alone.
PostureSummary posture_summary(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
