#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/input_error.hpp"
#include "stages/export/export_run.hpp"
#include "stages/export/lerobot/dataset_writer.hpp"
#include "stages/export/lerobot/robot_episode.hpp"
#include "stages/export/table/plan_table.hpp"

namespace morphe::exports {
namespace {

constexpr const char* kFrontMatter =
    "---\ntags:\n- LeRobot\n- robotics\ntask_categories:\n- robotics\nconfigs:\n- config_name: "
    "default\n  data_files: data/*/*.parquet\n---\n";

/// Returns the feature's numbers, in words.
std::string names_text(const Feature& feature) {
  std::string text;
  for (const std::string& name : feature.names)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", markdown_cell(name));
  return text;
}

std::string content_text(const ExportRun& run, const std::vector<Feature>& features) {
  std::string text = fmt::format(
      "**For learning, not for execution.** A frame every 1/{0:g} s is sampled from certified "
      "curves, but a controller that runs from frame to frame leaves them. To execute a plan, "
      "export it as `csv` or `ros`.\n\nA LeRobotDataset v3.0 at {0:g} frames per second, in the "
      "layout of LeRobot 0.6. Episode k is row k of `plans.parquet`, the table of quality. Frame k "
      "is at k/{0:g} s; the last one is the first that is not before the end of the motion, where "
      "the robot rests. `action` is the position of the joints at the next frame.\n\n"
      "| feature | numbers |\n|---|---|\n",
      run.options.motion.rate_hz);
  for (const Feature& feature : features)
    text += fmt::format("| `{}` | {} |\n", feature.name, names_text(feature));
  text +=
      "\nJoints are in rad (m for sliding ones), poses in the robot's base frame in m with "
      "quaternions w, x, y, z. `observation.environment_state` is the pose of the object that is "
      "grasped, which the hand carries; `observation.contact` is 1 while a pad touches it. "
      "`phase` is";
  for (std::size_t k = 0; k < enum_count<PhaseKind>(); ++k)
    text += fmt::format("{} {} {}", k == 0 ? "" : ",", k, name_of(static_cast<PhaseKind>(k)));
  return text + ".\n";
}

/// The plans of a dataset, those for training first.
struct Episodes {
  std::vector<ChosenPlan> plans;
  OptionalFeatures optional;
};

/// Finds the plans that can be exported, and the features that all of them have.
Episodes find_episodes(ExportRun& run) {
  Episodes episodes;
  for (const ChosenPlan& chosen : run.selection.plans) {
    const Plan plan = run.reader.read(chosen.index);
    const PlanMotions motions = motions_of(run.reader.robot(), plan, run.options.motion);
    if (!motions.rejection_reason.empty()) {
      run.index.skipped.push_back(
          {run.reader.plan_paths()[chosen.index], motions.rejection_reason});
      continue;
    }
    const OptionalFeatures own = optional_features(plan);
    episodes.optional.target = episodes.optional.target && own.target;
    episodes.optional.contacts = episodes.optional.contacts && own.contacts;
    run.has_approach_or_retreat =
        run.has_approach_or_retreat || plan.approach.samples() > 0 || plan.retreat.samples() > 0;
    episodes.plans.push_back(chosen);
  }
  if (episodes.plans.empty()) throw InputError("--format lerobot: no plan has a trajectory");
  std::stable_partition(episodes.plans.begin(), episodes.plans.end(),
                        [](const ChosenPlan& plan) { return plan.side != kValid; });
  return episodes;
}

EpisodeMotion episode_motion(const Plan& plan, PlanMotions motions, const MotionOptions& options) {
  EpisodeMotion motion{std::move(motions.motions.front().trajectory)};
  const Trajectory& own = plan.trajectory;
  if (options.approach == ApproachMode::joined && plan.retreat.samples() > 0)
    motion.end_s = time_before_s(plan, options) + own.time.back() - own.time[0];
  if (plan.grasp.sample >= 0 && plan.grasp.sample < std::ssize(own.time))
    motion.grasp_s = grasp_time_s(plan, options);
  return motion;
}

}  // namespace

void export_lerobot(ExportRun& run) {
  const RobotModel& robot = run.reader.robot();
  const MotionOptions& motion = run.options.motion;
  if (motion.rate_hz != std::round(motion.rate_hz))
    throw InputError(
        fmt::format("--fps {:g}: --format lerobot: must be a whole number of frames per second",
                    motion.rate_hz));
  const Episodes episodes = find_episodes(run);
  const std::vector<Feature> features = robot_features(robot, episodes.optional);
  files::AtomicFile& rows = run.files.add("plans.parquet");
  PlanTableWriter table(rows.part(), rows.target().string());
  LeRobotWriter writer(
      {static_cast<int>(motion.rate_hz), robot.name, features},
      [&](const std::string& name) -> files::AtomicFile& { return run.files.add(name); });
  int training = 0;
  for (const ChosenPlan& chosen : episodes.plans) {
    const Plan plan = run.reader.read(chosen.index);
    PlanMotions motions = motions_of(robot, plan, motion);
    writer.add(robot_episode(robot, plan, episode_motion(plan, std::move(motions), motion),
                             episodes.optional));
    table.add({robot, plan, chosen.side});
    run.selection.counts.add_chosen(plan, chosen.side);
    training += chosen.side != kValid ? 1 : 0;
  }
  table.finish();
  run.files.add("README.md", card_of(run, "Humanlike reach and grasp", kFrontMatter,
                                     content_text(run, features)));
  const int count = static_cast<int>(episodes.plans.size());
  std::map<std::string, std::pair<int, int>> splits{{"train", {0, training}}};
  if (training < count) splits["valid"] = {training, count};
  writer.finish(splits);
  for (const char* folder : {"data", "meta"}) run.files.expect_no_others(folder, ".parquet");
}

}  // namespace morphe::exports
