#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/plan.hpp"
#include "stages/import/audit/audit_options.hpp"

namespace morphe::imports {

/// A movement and what it is a part of, in one world frame.
struct AuditedMovement {
  const Demonstration& recording;  ///< with its objects
  const HumanMotion& motion;
  const Movement& movement;
  Goals goals = {};                         ///< of the robot's tips in the movement, in any frame
  std::string target_name = {};             ///< of the target in the configuration
  std::vector<std::string> obstacles = {};  ///< objects that cannot be the target
};

// The checks of a movement. Each returns its flags; there are none if the data do not allow it to
// judge.

/// The target, if it was recorded, is where the fingers close (target_distance.cpp).
std::vector<RecordingFlag> check_target(const AuditedMovement& audited,
                                        const AuditOptions& options);
/// The fingertips were seen where they are goals (goal_gaps.cpp).
std::vector<RecordingFlag> check_goals(const AuditedMovement& audited, const AuditOptions& options);
/// The movement begins and ends at rest (completeness.cpp).
std::vector<RecordingFlag> check_completeness(const AuditedMovement& audited,
                                              const AuditOptions& options);
/// A task that takes an object has a grasp (grasp_presence.cpp).
std::vector<RecordingFlag> check_grasp(const AuditedMovement& audited, const AuditOptions& options);

/// Sets the response of the flags that a recording accepts.
void accept_flags(const Demonstration& recording, std::vector<RecordingFlag>& flags);

/// Returns the flags of all checks above; accepted are those with a code that the recording
/// accepts.
std::vector<RecordingFlag> check_movement(const AuditedMovement& audited,
                                          const AuditOptions& options);

/// Returns the recording's flags that overlap the movement, and those of check_movement().
std::vector<RecordingFlag> audit_movement(const AuditedMovement& audited,
                                          const AuditOptions& options);

/// Returns the first flag that `options` refuse; nullptr if there is none.
const RecordingFlag* refused_flag(const std::vector<RecordingFlag>& flags,
                                  const AuditOptions& options);

}  // namespace morphe::imports
