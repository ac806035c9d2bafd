#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/hand_baselines.hpp"
#include "pipeline/study/hand_scores.hpp"
#include "pipeline/study/hands_options.hpp"
#include "pipeline/study/study.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

using Tips = std::vector<std::vector<Vec3>>;

constexpr double kMaxTipError_m = 0.008, kMaxPinchError_m = 0.004, kMaxAccelerationRatio = 1.5;
/// Hands with fewer joints cannot follow a tip in space.
constexpr int kMinJudgedJoints = 15;

/// Joins the mapped frames of all plans of a recording into one path. The human tips are the goals
/// divided by the hand scale, which shifts them: only their distances from each other are right.
HandPath path_of_plans(const std::vector<Plan>& plans, const robot::Robot& robot) {
  HandPath path;
  std::vector<JointVector> rows;
  for (const Plan& plan : plans) {
    for (Eigen::Index f = 0; f < plan.mapped.position.rows(); ++f) {
      path.time.push_back(plan.goals.time[f]);
      rows.push_back(plan.mapped.position.row(f).transpose());
      std::vector<Vec3>& goals = path.goals.emplace_back();
      std::vector<Vec3>& human = path.human.emplace_back();
      for (int i = 0; i < std::ssize(robot.tips); ++i) {
        goals.push_back(plan.goals.tip_position(f, i));
        human.push_back(goals.back() / plan.goals.hand_scale);
      }
    }
  }
  path.q.resize(rows.size(), robot.lower.size());
  for (int f = 0; f < std::ssize(rows); ++f) path.q.row(f) = rows[f].transpose();
  return path;
}

/// Computes the human tips relative to the wrist from the goals, by inverting their placement.
Tips tips_in_wrist_frame(const std::vector<Plan>& plans, const HandPath& path,
                         const robot::Robot& robot) {
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), poses);
  const Pose palm_from_base = poses[robot.palm_frame].inverse();
  const Goals& goals = plans.front().goals;
  Tips tips = path.goals;
  for (std::vector<Vec3>& frame : tips) {
    for (Vec3& tip : frame) {
      tip =
          (palm_from_base * tip - palm_from_base * goals.wrist_position.front()) / goals.hand_scale;
    }
  }
  return tips;
}

void add_rows(const HandScores& scores, const Case& condition, bool ours, const StudiedHand& hand,
              const robot::Robot& robot, std::ptrdiff_t frames, StudyResult& result) {
  const auto row = [&](auto... values) -> StudyRow& { return result.add(condition, values...); };
  StudyRow& mean = row("tip error, mean", "mm", 1e3 * scores.tip_mean_m, frames);
  if (ours && robot.joints() >= kMinJudgedJoints) mean.at_most = 1e3 * kMaxTipError_m;
  row("tip error, 95 %", "mm", 1e3 * scores.tip_95_m, frames);
  row("thumb-index error in pinches, median", "mm", 1e3 * scores.pinch_median_m, scores.pinches)
      .at_most = ours && hand.can_pinch ? 1e3 * kMaxPinchError_m : kUnknown;
  row("thumb-index distance, correlation with the human's", "1", scores.correlation, frames);
  row("largest step in 10 ms", "rad", scores.max_step_rad, frames);
  row("tip acceleration over goal acceleration", "1", scores.acceleration, frames).at_most =
      ours ? kMaxAccelerationRatio : kUnknown;
  row("frames with self-overlap", "1", scores.overlap_share, frames);
  row("largest self-overlap", "mm", 1e3 * scores.max_overlap_m, frames);
}

double processor_time_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void add_rate_row(const Case& condition, const char* metric, std::ptrdiff_t frames, double seconds,
                  StudyResult& result) {
  const double rate_hz = static_cast<double>(frames) / std::max(seconds, 1e-9);
  result.add(condition, metric, "1/s", rate_hz, frames).is_timing = true;
}

int frame_index(const robot::Robot& robot, const std::string& name) {
  if (name.empty()) return robot.palm_frame;
  for (int frame = 0; frame < std::ssize(robot.frames); ++frame) {
    if (robot.frames[frame].name == name) return frame;
  }
  throw InputError(fmt::format("robots: {} has no frame '{}'", robot.name, name));
}

void add_baseline_rows(const StudiedHand& hand, const robot::Robot& robot, const HandPath& ours,
                       Tips human, double our_scale, const HandsStudyOptions& options, bool quick,
                       const Case& condition, StudyResult& result) {
  if (quick && options.quick_frames < std::ssize(human)) human.resize(options.quick_frames);
  const BaselineHand baseline{robot, frame_index(robot, hand.vector_origin),
                              hand.scale.value_or(our_scale)};
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), poses);
  Pose base_from_origin = poses[baseline.origin];
  base_from_origin.linear() = poses[robot.palm_frame].linear();
  for (const BaselineMethod method : {BaselineMethod::vector, BaselineMethod::dexpilot}) {
    HandPath path;
    path.time.assign(ours.time.begin(), ours.time.begin() + human.size());
    path.human = path.goals = human;
    for (std::vector<Vec3>& frame : path.goals) {
      for (Vec3& tip : frame) tip = base_from_origin * Vec3(baseline.scale * tip);
    }
    const double begin_s = processor_time_s();
    path.q = baseline_path(method, baseline, human);
    const double mapping_s = processor_time_s() - begin_s;
    const Case own = case_with(condition, "method", std::string(name_of(method)));
    add_rows(score_hand(robot, path, options.pinch_distance), own, false, hand, robot, human.size(),
             result);
    add_rate_row(own, "frames per second, mapping", human.size(), mapping_s, result);
  }
}

void study_hand(const StudiedHand& hand, const Demonstration& demonstration,
                const HandsStudyOptions& options, const StudyRun& run, StudyResult& result) {
  const std::filesystem::path folder = std::filesystem::absolute(run.config).parent_path();
  const planning::LoadedConfig config =
      planning::load_config(folder / options.pipeline,
                            {"robot.file=" + (folder / hand.file).lexically_normal().string()});
  const robot::Robot& robot = config.robot;
  const planning::PlanningInputs planner{config.options, robot};
  const double begin_s = processor_time_s();
  const run::DemonstrationOutcome outcome = planning::plan_demonstration(planner, demonstration);
  const double all_steps_s = processor_time_s() - begin_s;
  const HandPath path = path_of_plans(outcome.plans, robot);
  if (path.time.empty())
    throw InputError(fmt::format("{}: {}", hand.file, outcome.plans.front().detail));
  const Case condition = {{"recording", demonstration.name}, {"hand", robot.name}};
  const Case own = case_with(condition, "method", "Morphe");
  add_rows(score_hand(robot, path, options.pinch_distance), own, true, hand, robot,
           path.time.size(), result);
  double human_s = 0, human_with_trajectory_s = 0, robot_s = 0;
  for (const Plan& plan : outcome.plans) {
    const double movement_s = plan.movement.end_s - plan.movement.begin_s;
    human_s += movement_s;
    if (!plan.has_trajectory()) continue;
    human_with_trajectory_s += movement_s;
    robot_s += plan.trajectory.time.back();
  }
  const auto row = [&](const char* metric, double value) {
    result.add(own, metric, "1", value, outcome.plans.size());
  };
  row("scale of the human hand", outcome.plans.front().goals.hand_scale);
  row("share of the recording with a trajectory", human_with_trajectory_s / human_s);
  row("duration ratio", human_with_trajectory_s > 0 ? robot_s / human_with_trajectory_s : kUnknown);
  const auto mapping = outcome.stage_cpu_s.find("map");
  if (mapping != outcome.stage_cpu_s.end())
    add_rate_row(own, "frames per second, mapping", path.time.size(), mapping->second, result);
  add_rate_row(own, "frames per second, all steps", path.time.size(), all_steps_s, result);
  add_baseline_rows(hand, robot, path, tips_in_wrist_frame(outcome.plans, path, robot),
                    outcome.plans.front().goals.hand_scale, options, run.quick, condition, result);
  run.progress(fmt::format("{}, {}", demonstration.name, robot.name));
}

}  // namespace

std::string validation_error(const HandsStudyOptions& options) {
  if (options.robots.empty()) return "robots must contain at least one hand";
  return "";
}

StudyResult hands_study(const config::ConfigNode& config, const StudyRun& run) {
  HandsStudyOptions options;
  config::read_document(config, options);
  if (run.quick && options.quick_robots < std::ssize(options.robots))
    options.robots.resize(options.quick_robots);
  StudyResult result;
  imports::ImportRequest request;
  request.paths = {run.config.parent_path() / options.manifest};
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    for (const StudiedHand& hand : options.robots)
      study_hand(hand, demonstration, options, run, result);
  });
  return result;
}

}  // namespace morphe::study
