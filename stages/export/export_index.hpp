#pragma once

#include <string>
#include <vector>

#include "core/math/quintic.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/export/joint_group.hpp"
#include "stages/export/plan_motions.hpp"

namespace morphe::exports {

struct IndexedMotion {
  std::string what;
  double duration_s = 0;
  std::size_t points = 0;
  std::vector<std::string> files;  ///< one a group
  math::LimitReport limits;        ///< of the quintics between the points; only if resampled
};

struct IndexedPlan {
  std::string plan;                    ///< <demonstration>/<000>
  Status status = Status::executable;  ///< or approximate
  std::string subject, task;
  std::vector<IndexedMotion> motions;
  std::vector<std::string> grasp_files;  ///< beside them, of a plan that names contacts
};

struct LeftOut {
  std::string plan, why;
};

/// What a script needs to run the files of one export one after the other.
struct ExportIndex {
  std::string format;
  MotionOptions motion;
  double rate_hz = 0;  ///< of the points, whether resampled or not
  std::vector<JointGroup> groups;
  std::vector<IndexedPlan> plans;
  std::vector<LeftOut> left_out;
};

/// JSON (docs/formats.md).
std::string index_json(const ExportIndex& index, const PlanFileHeader& header,
                       const RobotTable& robot);

}  // namespace morphe::exports
