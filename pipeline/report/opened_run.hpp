#pragma once

#include <memory>
#include <optional>

#include "core/robot/robot.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/report/report.hpp"

namespace morphe::report {

/// A plans.h5 ready to be shown.
struct OpenedRun {
  ReportRequest::Run named;
  std::unique_ptr<store::PlanReader> reader;
  robot::Robot robot;
  std::optional<Eigen::Matrix3d> world_from_base;  ///< none: the config does not say
  Selected selected;
};
std::vector<OpenedRun> open_runs(const ReportRequest& request);

}  // namespace morphe::report
