#pragma once

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/explain/figure_cause.hpp"
#include "pipeline/explain/palm_floor.hpp"
#include "pipeline/explain/wrist_offset.hpp"

namespace morphe::explain {

/// A figure of the driven posture, the least that the same wrist (or, of the palm, the same tips)
/// would allow, and that of the posture with the same tips which serves both links and the palm
/// best: means over the samples [rad]. And its causes.
struct PostureFigure {
  double driven = kUnknown, least = kUnknown, with_tips = kUnknown;
  FigureCauses causes;
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
