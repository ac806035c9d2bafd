#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe {

/// The requirements on the plans of a file, according to the file's own config and inputs. The
/// verifier needs them independently of how they are read (planning::plan_requirements reads them).
struct PlanRequest {
  RobotModel robot;  ///< as described by the stored inputs
  std::string config_sha256;
  Tolerances tolerances;
  double goal_step_s = 0.01;  ///< time step between the frames of the goals
  double limit_scaling = 1;   ///< factor on the limits of velocity, acceleration and jerk
  /// The last phase that is planned; absent if parts of movements or whole recordings are planned.
  std::optional<PhaseKind> plan_until;
  /// The same for tasks that contain a word; the first word that a task contains counts.
  std::vector<std::pair<std::string, PhaseKind>> plan_until_by_task;
  PartialPlans partial = PartialPlans::at_rest;  ///< parts of movements that may be delivered
  std::vector<FlagCode> refused_flags;  ///< with which no movement is planned, unless accepted
  std::string carrier_frame;  ///< frame to which the target is attached, "" if it moves as recorded

  /// The posture at which the approach starts and the retreat ends; absent without an approach.
  struct Home {
    JointVector posture;       ///< [n]
    double limit_scaling = 1;  ///< multiplied by the factor for the motion
    bool with_retreat = true;  ///< true if a retreat is requested too
  };
  std::optional<Home> home;

  /// The frame of a body's pose (WorldFrames); `unknown` if only the body's name is known.
  enum class ReferenceFrame { unknown, world, table, target, shoulder, base };
  /// A fixed body of the config or its scene file, with its pose.
  struct Body {
    SceneObject object;
    ReferenceFrame relative_to = ReferenceFrame::unknown;
  };
  std::vector<Body> bodies;

  /// The assumptions of robot and config, without settings given by hand.
  std::vector<Assumption> assumptions;
  std::vector<Knowable> must_be_known;  ///< what may be neither assumed nor inferred
};

}  // namespace morphe
