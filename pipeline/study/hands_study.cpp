#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/hand_baselines.hpp"
#include "pipeline/study/hand_scores.hpp"
#include "pipeline/study/hands_options.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/study.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

using Tips = std::vector<std::vector<Vec3>>;

constexpr double kMaxTipError_m = 0.008, kMaxPinchError_m = 0.004, kMaxAccelerationRatio = 1.5;
/// Hands with fewer joints cannot follow a tip in space.
constexpr std::size_t kMinJudgedJoints = 15;

/// Joins all parts of a recording into one path. The human tips are the goals divided by the hand
/// scale; because they refer to its own origin, only their distances are meaningful.
HandPath path_of_plans(const std::vector<Plan>& plans, const robot::Robot& robot) {
  HandPath course;
  std::vector<JointVector> rows;
  for (const Plan& plan : plans) {
    for (std::size_t f = 0; f < static_cast<std::size_t>(plan.mapped.position.rows()); ++f) {
      course.time.push_back(plan.goals.time[f]);
      rows.push_back(plan.mapped.position.row(f).transpose());
      std::vector<Vec3>& goals = course.goals.emplace_back();
      std::vector<Vec3>& human = course.human.emplace_back();
      for (std::size_t i = 0; i < robot.tips.size(); ++i) {
        goals.push_back(plan.goals.tip_position(f, i));
        human.push_back(goals.back() / plan.goals.hand_scale);
      }
    }
  }
  course.q.resize(rows.size(), robot.lower.size());
  for (std::size_t f = 0; f < rows.size(); ++f) {
    course.q.row(f) = rows[f].transpose();
  }
  return course;
}

/// Computes the human tips relative to the wrist, in the robot's order, from the goals of a plan by
/// inverting its placement.
Tips tips_in_wrist_frame(const std::vector<Plan>& plans, const HandPath& course,
                         const robot::Robot& robot) {
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), poses);
  const Pose palm_from_base = poses[robot.palm_frame].inverse();
  const Goals& goals = plans.front().goals;
  Tips tips = course.goals;
  for (std::vector<Vec3>& frame : tips) {
    for (Vec3& tip : frame) {
      tip =
          (palm_from_base * tip - palm_from_base * goals.wrist_position.front()) / goals.hand_scale;
    }
  }
  return tips;
}

void add_rows(const HandScores& scores, const Case& of, bool ours, const StudiedHand& hand,
              std::size_t joints, std::size_t frames, StudyResult& result) {
  const auto row = [&](const char* metric, const char* unit, double value,
                       std::size_t n) -> StudyRow& {
    result.rows.push_back(make_row(of, metric, unit, value, n));
    return result.rows.back();
  };
  StudyRow& mean = row("tip error, mean", "mm", 1e3 * scores.tip_mean_m, frames);
  if (ours && joints >= kMinJudgedJoints) mean.at_most = 1e3 * kMaxTipError_m;
  row("tip error, 95 %", "mm", 1e3 * scores.tip_95_m, frames);
  StudyRow& pinch = row("thumb-index error in pinches, median", "mm", 1e3 * scores.pinch_median_m,
                        scores.pinches);
  if (ours && hand.can_pinch) pinch.at_most = 1e3 * kMaxPinchError_m;
  row("thumb-index distance, correlation with the human's", "1", scores.correlation, frames);
  row("largest step in 10 ms", "rad", scores.max_step_rad, frames);
  StudyRow& acceleration =
      row("tip acceleration over goal acceleration", "1", scores.acceleration, frames);
  if (ours) acceleration.at_most = kMaxAccelerationRatio;
  row("frames with self-overlap", "1", scores.overlap_share, frames);
  row("largest self-overlap", "mm", 1e3 * scores.max_overlap_m, frames);
}

double processor_time_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void timed_row(const Case& of, const char* metric, std::size_t frames, double seconds,
               StudyResult& result) {
  result.rows.push_back(
      make_row(of, metric, "1/s", static_cast<double>(frames) / std::max(seconds, 1e-9), frames));
  result.rows.back().is_timing = true;
}

int frame_index(const robot::Robot& robot, const std::string& name) {
  if (name.empty()) return robot.palm_frame;
  const auto found = std::ranges::find(robot.frames, name, &RobotModel::Frame::name);
  if (found == robot.frames.end()) {
    throw InputError(fmt::format("robots: {} has no frame '{}'", robot.name, name));
  }
  return static_cast<int>(found - robot.frames.begin());
}

void add_baseline_rows(const StudiedHand& hand, const robot::Robot& robot, const HandPath& ours,
                       Tips human, double found_scale, const HandsStudyOptions& options, bool quick,
                       const Case& of, StudyResult& result) {
  if (quick) {
    const auto most = static_cast<std::size_t>(options.quick_frames);
    human.resize(std::min(human.size(), most));
  }
  const BaselineHand peer{robot, frame_index(robot, hand.vector_origin),
                          hand.scale.value_or(found_scale)};
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), poses);
  Pose base_from_origin = poses[peer.origin];
  base_from_origin.linear() = poses[robot.palm_frame].linear();
  for (const BaselineMethod method : {BaselineMethod::vector, BaselineMethod::dexpilot}) {
    HandPath course;
    course.time.assign(ours.time.begin(), ours.time.begin() + human.size());
    course.human = course.goals = human;
    for (std::vector<Vec3>& frame : course.goals) {
      for (Vec3& tip : frame) tip = base_from_origin * Vec3(peer.scale * tip);
    }
    const double before_s = processor_time_s();
    course.q = baseline_path(method, peer, human);
    const double took_s = processor_time_s() - before_s;
    Case own = of;
    own.emplace_back("method", std::string(name_of(method)));
    add_rows(score_hand(robot, course, options.pinch_distance), own, false, hand, robot.joints(),
             human.size(), result);
    timed_row(own, "frames per second, mapping", human.size(), took_s, result);
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
  const double before_s = processor_time_s();
  const run::DemonstrationOutcome outcome = planning::plan_demonstration(planner, demonstration);
  const double took_s = processor_time_s() - before_s;
  const HandPath course = path_of_plans(outcome.plans, robot);
  if (course.time.empty()) {
    throw InputError(fmt::format("{}: {}", hand.file, outcome.plans.front().detail));
  }
  const Case of = {{"recording", demonstration.name}, {"hand", robot.name}};
  Case own = of;
  own.emplace_back("method", "Morphe");
  add_rows(score_hand(robot, course, options.pinch_distance), own, true, hand, robot.joints(),
           course.time.size(), result);
  double with_trajectory_s = 0, whole_s = 0, tempo_s = 0;
  for (const Plan& plan : outcome.plans) {
    const double span = plan.movement.end_s - plan.movement.begin_s;
    whole_s += span;
    if (!plan.has_trajectory()) continue;
    with_trajectory_s += span;
    tempo_s += plan.trajectory.time.back();
  }
  const auto row = [&](const char* metric, const char* unit, double value) {
    result.rows.push_back(make_row(own, metric, unit, value, outcome.plans.size()));
  };
  row("scale of the human hand", "1", outcome.plans.front().goals.hand_scale);
  row("share of the recording with a trajectory", "1", with_trajectory_s / whole_s);
  row("duration ratio", "1", with_trajectory_s > 0 ? tempo_s / with_trajectory_s : kUnknown);
  const auto mapping = outcome.stage_cpu_s.find("map");
  if (mapping != outcome.stage_cpu_s.end()) {
    timed_row(own, "frames per second, mapping", course.time.size(), mapping->second, result);
  }
  timed_row(own, "frames per second, all steps", course.time.size(), took_s, result);
  add_baseline_rows(hand, robot, course, tips_in_wrist_frame(outcome.plans, course, robot),
                    outcome.plans.front().goals.hand_scale, options, run.quick, of, result);
  run.progress(fmt::format("{}, {}", demonstration.name, robot.name));
}

}  // namespace

std::string validation_error(const StudiedHand& hand) {
  return hand.scale && !(*hand.scale > 0) ? "scale must be positive" : "";
}

std::string validation_error(const HandsStudyOptions& options) {
  if (options.robots.empty()) return "robots must contain at least one hand";
  if (!(options.pinch_distance > 0)) return "pinch_distance must be positive";
  if (options.quick_robots < 1) return "quick_robots must be at least 1";
  if (options.quick_frames < 5) return "quick_frames must be at least 5";
  return "";
}

StudyResult hands_study(const config::ConfigNode& config, const StudyRun& run) {
  HandsStudyOptions options;
  config::read_document(config, options);
  if (run.quick) {
    const auto most = static_cast<std::size_t>(options.quick_robots);
    options.robots.resize(std::min(options.robots.size(), most));
  }
  StudyResult result;
  imports::ImportRequest request;
  request.paths = {run.config.parent_path() / options.manifest};
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    for (const StudiedHand& hand : options.robots) {
      study_hand(hand, demonstration, options, run, result);
    }
  });
  return result;
}

}  // namespace morphe::study
