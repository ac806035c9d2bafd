#pragma once

#include <memory>
#include <optional>

#include "core/robot/robot.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/explain/advice.hpp"
#include "pipeline/report/report.hpp"

namespace morphe::report {

/// A plans.h5 and what it contains for all its plans.
struct OpenedRun {
  ReportRequest::Run request;
  std::unique_ptr<store::PlanReader> reader;
  robot::Robot robot;
  std::optional<Eigen::Matrix3d> world_from_base;  ///< rotation; empty if unknown
  explain::AdviceContext advice;                   ///< of the config in the file
  SelectedPlans selected;
};
/// Opens all runs of a request and selects their plans. Throws InputError for a file that cannot be
/// read, and if no run has a plan of the requested names.
std::vector<OpenedRun> open_runs(const ReportRequest& request);

}  // namespace morphe::report
