#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "stages/export/export_run.hpp"
#include "stages/export/grasp_files.hpp"
#include "stages/export/limit_use.hpp"
#include "stages/export/resample.hpp"
#include "stages/export/ros_trajectory.hpp"
#include "stages/export/trajectory_csv.hpp"

namespace morphe::exports {
namespace {

/// A format that writes one text per motion and joint group.
struct TextFormat {
  const char* name;
  const char* ending;
  std::string (*text_of)(const JointGroup&, const Trajectory&);
};
constexpr TextFormat kTextFormats[] = {
    {"csv", ".csv", trajectory_csv},
    {"ros", ".yaml", ros_trajectory_yaml},
    {"ros-json", ".json", ros_trajectory_json},
};

/// Adds the files of a grasp with contacts: two tables, or one JSON file.
void export_grasp(ExportRun& run, const Plan& plan, bool tables) {
  if (!has_contacts(plan) || plan.grasp.sample >= std::ssize(plan.trajectory.time)) return;
  const RobotModel& robot = run.reader.robot();
  IndexedPlan& indexed = run.index.plans.back();
  const std::string name = fmt::format("{}_{:03}", plan.demonstration, plan.movement.index);
  const auto add = [&](const char* ending, const std::string& text) {
    run.files.add(name + ending, text);
    indexed.grasp_files.push_back(name + ending);
  };
  if (tables) {
    add("_contacts.csv", contacts_csv(plan));
    add("_grasp_force.csv", grasp_force_csv(robot, plan));
  } else {
    add("_grasp.json",
        grasp_json(robot, plan, indexed.plan, grasp_time_s(plan, run.options.motion)));
  }
}

/// Returns the least number of points per sample at which cubic Hermite pieces between them are
/// within the limits, too, for all motions; 1 if they are not up to kMaxDividedRate_hz.
int points_per_sample(const ExportRun& run) {
  constexpr double kMaxDividedRate_hz = 4000;
  int parts = 1;
  for (const ChosenPlan& chosen : run.selection.plans) {
    const Plan plan = run.reader.read(chosen.index);
    const PlanMotions whole = motions_of(run.reader.robot(), plan, run.options.motion);
    for (const PlanMotion& motion : whole.motions) {
      const double rate_hz = sample_rate_hz(plan.trajectory);
      const auto holds = [&] {
        return cubic_holds(limit_use(run.reader.robot(), subdivide(motion.trajectory, parts)));
      };
      while (!holds())
        if (++parts * rate_hz > kMaxDividedRate_hz) return 1;
    }
  }
  return parts;
}

}  // namespace

std::vector<std::string> text_format_names() {
  std::vector<std::string> names;
  for (const TextFormat& format : kTextFormats) names.push_back(format.name);
  return names;
}

void export_texts(ExportRun& run) {
  const auto found = std::ranges::find(kTextFormats, run.options.format, &TextFormat::name);
  assert(found != std::end(kTextFormats));
  const TextFormat& format = *found;
  run.index.has_limits = true;
  if (run.options.motion.rate_hz == 0)
    run.index.motion.parts = run.options.motion.parts = points_per_sample(run);
  for (const ChosenPlan& chosen : run.selection.plans) {
    const Plan plan = run.reader.read(chosen.index);
    const std::vector<PlanMotion> motions = add_to_index(run, chosen, plan);
    for (int m = 0; m < std::ssize(motions); ++m) {
      const std::string suffix = motions[m].name == "trajectory" ? "" : "_" + motions[m].name;
      for (const JointGroup& group : run.index.groups) {
        const std::string name =
            fmt::format("{}_{:03}{}{}{}", plan.demonstration, plan.movement.index, suffix,
                        group.name == "all" ? "" : "_" + group.name, format.ending);
        run.files.add(name, format.text_of(group, select_joints(motions[m].trajectory, group)));
        run.index.plans.back().motions[m].files.push_back(name);
      }
    }
    if (!motions.empty()) export_grasp(run, plan, format.text_of == trajectory_csv);
  }
}

}  // namespace morphe::exports
