#pragma once

#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/export/joint_group.hpp"
#include "stages/export/limit_use.hpp"
#include "stages/export/plan_motions.hpp"

namespace morphe::exports {

/// A phase of an exported motion, as a segment of its points.
struct IndexedPhase {
  PhaseKind kind = PhaseKind::rest;
  std::size_t first_point = 0, last_point = 0;
  double begin_s = 0, end_s = 0;  ///< in the motion; it ends where the next one begins
};

/// The files of one exported motion.
struct IndexedMotion {
  std::string name;  ///< trajectory, approach or retreat
  double duration_s = 0;
  std::size_t points = 0;          ///< number of points
  std::vector<std::string> files;  ///< one per group
  std::vector<IndexedPhase> phases;
  MotionLimitUse limits;  ///< between the points; only of text formats
};

/// The exported files of one plan.
struct IndexedPlan {
  std::string plan;                    ///< <demonstration>/<000>
  Status status = Status::executable;  ///< executable, approximate or partial
  std::string subject, task;
  std::string_view side;                ///< train or valid, "" without a split
  std::vector<RecordingFlag> flags;     ///< doubts about the recording
  std::vector<Assumption> assumptions;  ///< about recording and objects
  std::vector<IndexedMotion> motions;
  std::vector<std::string> grasp_files;  ///< files of the grasp, for a plan with contacts
};

/// A plan that was not exported, and the reason.
struct SkippedPlan {
  std::string plan, reason;
};

/// The files of one export, with which a script can execute them in order.
struct ExportIndex {
  std::string format;        ///< one of export_format_names()
  std::string not_verified;  ///< as in ExportOptions
  std::string where;         ///< as in ExportOptions
  MotionOptions motion;
  double rate_hz = 0;       ///< rate of the points, resampled or not
  bool has_limits = false;  ///< true if the motions have their limits
  std::vector<JointGroup> groups;
  std::vector<IndexedPlan> plans;
  std::vector<SkippedPlan> skipped;
};

/// Returns the index as JSON (docs/formats.md).
std::string index_json(const ExportIndex& index, const PlanFileHeader& header,
                       const RobotModel& robot);

}  // namespace morphe::exports
