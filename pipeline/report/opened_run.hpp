#pragma once

#include <memory>
#include <optional>

#include "core/robot/robot.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/report/report.hpp"

namespace morphe::report {

/// A plans.h5 that is ready for display.
struct OpenedRun {
  /// The request for this run.
  ReportRequest::Run request;
  /// The open file.
  std::unique_ptr<store::PlanReader> reader;
  /// The robot of the file.
  robot::Robot robot;
  /// Rotation of the base, empty if the config does not contain it.
  std::optional<Eigen::Matrix3d> world_from_base;
  /// The plans to be shown.
  SelectedPlans selected;
};
/// Opens all runs of a request and selects their plans.
std::vector<OpenedRun> open_runs(const ReportRequest& request);

}  // namespace morphe::report
