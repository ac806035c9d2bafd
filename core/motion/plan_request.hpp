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
  /// Differences of the header from its inputs and settings: "@config: KEY OLD -> NEW" with
  /// the header's value and the one that follows, or the name of an attribute.
  std::vector<std::string> header_faults;
  Tolerances tolerances;
  double goal_step_s = 0.01;     ///< time step between the frames of the goals
  double sample_step_s = 0.002;  ///< time step between the samples of trajectories
  double limit_scaling = 1;      ///< factor on the limits of velocity, acceleration and jerk
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

  /// The frame of a body's pose (WorldFrames).
  enum class ReferenceFrame { world, table, target, shoulder, base };
  /// A fixed body of the config or its scene file, with its pose.
  struct Body {
    SceneObject object;
    ReferenceFrame relative_to = ReferenceFrame::world;
  };
  std::vector<Body> bodies;

  /// The placement of the robot: the rotation and the robot's shoulder, relative to the person's,
  /// follow from the config alone; a hand alone has a fixed pose in the person's hand.
  struct Placement {
    Eigen::Matrix3d world_from_base = Eigen::Matrix3d::Identity();
    Vec3 shoulder_offset = Vec3::Zero();  ///< from the person's to the robot's shoulder, in world
    double base_offset_limit =
        0;  ///< per axis of an offset chosen for a movement; 0: no such offset
    bool hand_only = false;
  };
  Placement placement;

  /// The shape of a target. A recorded one gets `body` too; without it and without `radius`, one
  /// that was not recorded has a radius within the bounds.
  struct TargetShape {
    std::optional<SceneObject> body;  ///< only its shape counts
    std::optional<double> radius;
    double min_radius = 0, max_radius = kInfinity;
  };
  TargetShape target;
  /// Names and radii of the capsules of the person's other arm, if it is an obstacle.
  std::vector<std::pair<std::string, double>> other_arm;

  /// The assumptions of robot and config, and the settings given by hand.
  std::vector<Assumption> assumptions;
  std::vector<Knowable> must_be_known;  ///< what may be neither assumed nor inferred
};

}  // namespace morphe
