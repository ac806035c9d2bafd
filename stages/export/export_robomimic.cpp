#include <algorithm>
#include <cmath>

#include "stages/export/export_run.hpp"
#include "stages/export/robomimic.hpp"

namespace morphe::exports {
namespace {

/// Returns the plan with its motion at the times of the frames, and the grasp at the first frame
/// that is not before it.
Plan resampled(const RobotModel& robot, Plan plan, const MotionOptions& options) {
  const double grasp_s = plan.grasp.sample >= 0 ? grasp_time_s(plan, options) : 0;
  plan.trajectory = std::move(motions_of(robot, plan, options).motions.front().trajectory);
  constexpr double kTolerance_s = 1e-9;
  if (plan.grasp.sample >= 0)
    plan.grasp.sample =
        static_cast<int>(std::ranges::lower_bound(plan.trajectory.time, grasp_s - kTolerance_s) -
                         plan.trajectory.time.begin());
  return plan;
}

}  // namespace

void export_robomimic(ExportRun& run) {
  // Reads the file twice: demonstrations have the target's pose only if all plans have a target.
  const std::string name = "robomimic.hdf5";
  std::vector<ChosenPlan> exported;
  bool target = true;
  for (const ChosenPlan& chosen : run.selection.plans) {
    const Plan plan = run.reader.read(chosen.index);
    if (add_to_index(run, chosen, plan).empty()) continue;
    run.index.plans.back().motions.front().files.push_back(name);
    target = target && plan.grasp.sample >= 0;
    exported.push_back(chosen);
  }
  if (exported.empty()) return;
  const RobotModel& robot = run.reader.robot();
  RobomimicWriter writer(run.files.add(name),
                         robomimic_header(robot, run.index.rate_hz, run.options.not_verified));
  for (const ChosenPlan& chosen : exported) {
    const Plan plan = resampled(robot, run.reader.read(chosen.index), run.options.motion);
    RobomimicDemo demo = robomimic_demo(robot, plan, target);
    demo.is_valid = chosen.side == kValid;
    writer.add(demo);
  }
  writer.finish();
}

}  // namespace morphe::exports
