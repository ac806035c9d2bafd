#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe {

/// What the plans of a file were asked to be, as the file's own config and inputs say. Who judges
/// them needs it, but not how it is read (planning::asked_of reads it).
struct Asked {
  RobotTable robot;  ///< as the stored inputs describe it
  std::string config_sha256;
  Tolerances tolerances;
  double goal_step_s = 0.01;  ///< between the frames of the goals
  double limit_share = 1;     ///< of velocity, acceleration and jerk that a motion uses
  /// The last phase that is planned; none: parts of movements, or recordings as a whole.
  std::optional<PhaseKind> plan_until;
  std::string carrier;  ///< frame that carries the target, "" if its recorded way does

  /// Where approach and retreat begin and end; none: they are not asked for.
  struct Home {
    JointVector posture;     ///< [n]
    double limit_share = 1;  ///< beside that of the motion
    bool back = true;        ///< a retreat too
  };
  std::optional<Home> home;

  /// What the place of a body is given in (WorldFrames); unknown: no more than its name is known.
  enum class Relative { unknown, world, table, target, shoulder, base };
  /// A fixed body of the config or its scene file, with its one pose.
  struct Body {
    SceneObject object;
    Relative relative_to = Relative::unknown;
  };
  std::vector<Body> bodies;
};

}  // namespace morphe
