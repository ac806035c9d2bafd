#include "stages/export/export_plans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/assumption_text.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/plan_file.hpp"
#include "stages/export/grasp_files.hpp"
#include "stages/export/limit_use.hpp"
#include "stages/export/resample.hpp"
#include "stages/export/robomimic.hpp"
#include "stages/export/ros_trajectory.hpp"
#include "stages/export/staged_files.hpp"
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
constexpr const char* kRobomimic = "robomimic";

struct Export {
  const store::PlanReader& reader;
  ExportOptions options;
  StagedFiles files;
  ExportIndex index;
  WorstLimitUse limits;
  bool has_approach_or_retreat = false;  ///< true if a plan has an approach or a retreat
};

/// Returns the rate of the planned samples, which are equidistant, rounded to 1e-6 Hz.
double sample_rate_hz(const Trajectory& t) {
  return std::round(1e6 * static_cast<double>(t.samples() - 1) / (t.time.back() - t.time[0])) / 1e6;
}

/// Returns true if all times fit the 32-bit seconds of ROS messages.
bool fits_ros_duration(const std::vector<PlanMotion>& motions) {
  constexpr double kMaxRosTime_s = 2147483647;
  return std::ranges::all_of(motions, [&](const PlanMotion& motion) {
    return std::ranges::all_of(motion.trajectory.time,
                               [&](double t) { return std::abs(t) <= kMaxRosTime_s; });
  });
}

/// Enters the plan's motions into the index, without files, and returns them; empty if the plan is
/// skipped.
std::vector<PlanMotion> add_to_index(Export& run, std::size_t i, const Plan& plan) {
  const MotionOptions& options = run.options.motion;
  auto [motions, reason] = motions_of(run.reader.robot(), plan, options);
  if (reason.empty() && run.options.format.starts_with("ros") && !fits_ros_duration(motions))
    reason = "is longer than a ROS message can express (2^31 s)";
  if (!reason.empty()) {
    run.index.skipped.push_back({run.reader.plan_paths()[i], reason});
    return {};
  }
  if (run.index.plans.empty())
    run.index.rate_hz =
        options.rate_hz > 0 ? options.rate_hz : options.parts * sample_rate_hz(plan.trajectory);
  run.has_approach_or_retreat =
      run.has_approach_or_retreat || plan.approach.samples() > 0 || plan.retreat.samples() > 0;
  IndexedPlan& indexed = run.index.plans.emplace_back();
  indexed.plan = run.reader.plan_paths()[i];
  indexed.status = plan.status();
  indexed.subject = plan.subject;
  indexed.flags = plan.flags;
  indexed.assumptions = plan_assumptions(plan);
  indexed.task = plan.task;
  for (const auto& [name, t] : motions) {
    IndexedMotion& entry = indexed.motions.emplace_back();
    entry.name = name;
    entry.duration_s = t.time.back() - t.time[0];
    entry.points = t.samples();
    if (!run.index.has_limits) continue;
    entry.limits = limit_use(run.reader.robot(), t);
    run.limits.add(entry.limits, indexed.plan);
  }
  return std::move(motions);
}

/// Returns the time of the grasp in the exported motion "trajectory".
double grasp_time_s(const Plan& plan, const MotionOptions& options) {
  const bool joined = options.approach == ApproachMode::joined && plan.approach.samples() > 0;
  const double before_s =
      options.delay_s + (joined ? plan.approach.time.back() - plan.approach.time[0] : 0);
  const Trajectory& t = plan.trajectory;
  return before_s + t.time[plan.grasp.sample] - t.time[0];
}

/// Adds the files of a grasp with contacts: two tables, or one JSON file.
void export_grasp(Export& run, const Plan& plan, bool tables) {
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
int points_per_sample(const Export& run) {
  constexpr double kMaxDividedRate_hz = 4000;
  int parts = 1;
  for (std::size_t i = 0; i < run.reader.size(); ++i) {
    const Plan plan = run.reader.read(i);
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

void export_texts(Export& run, const TextFormat& format) {
  run.index.has_limits = true;
  if (run.options.motion.rate_hz == 0)
    run.index.motion.parts = run.options.motion.parts = points_per_sample(run);
  for (std::size_t i = 0; i < run.reader.size(); ++i) {
    const Plan plan = run.reader.read(i);
    const std::vector<PlanMotion> motions = add_to_index(run, i, plan);
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

void export_robomimic(Export& run) {
  // Reads the file twice: demonstrations have the target's pose only if all plans have a target.
  const std::string name = "robomimic.hdf5";
  std::vector<std::size_t> chosen;
  bool target = true;
  for (std::size_t i = 0; i < run.reader.size(); ++i) {
    const Plan plan = run.reader.read(i);
    if (add_to_index(run, i, plan).empty()) continue;
    run.index.plans.back().motions.front().files.push_back(name);
    target = target && plan.grasp.sample >= 0;
    chosen.push_back(i);
  }
  if (chosen.empty()) return;
  const RobotModel& robot = run.reader.robot();
  RobomimicWriter writer(run.files.add(name),
                         robomimic_header(robot, run.index.rate_hz, run.options.not_verified));
  for (const std::size_t i : chosen) {
    Plan plan = run.reader.read(i);
    plan.trajectory =
        std::move(motions_of(robot, plan, run.options.motion).motions.front().trajectory);
    writer.add(robomimic_demo(robot, plan, target));
  }
  writer.finish();
}

void check_robomimic(const ExportOptions& options) {
  const auto refuse = [](const char* option, const char* reason) {
    throw InputError(fmt::format("--format robomimic: {}: omit {}", reason, option));
  };
  if (options.groups != std::vector<std::string>{"all"})
    refuse("--group", "always contains all joints");
  if (options.motion.delay_s > 0) refuse("--delay", "a wait is not part of a demonstration");
  if (options.motion.approach == ApproachMode::joined)
    refuse("--approach", "approach and retreat are not part of a demonstration");
}

void check_joined(const Export& run) {
  if (run.options.motion.approach != ApproachMode::joined || run.has_approach_or_retreat ||
      run.index.plans.empty())
    return;
  throw InputError(
      "--approach joined: no plan has an approach: plan with the section `approach` "
      "(docs/steps/approach.md), or omit --approach");
}

}  // namespace

std::vector<std::string> export_format_names() {
  std::vector<std::string> names;
  for (const TextFormat& format : kTextFormats) names.push_back(format.name);
  names.push_back(kRobomimic);
  return names;
}

ExportReport export_plans(const std::filesystem::path& plans, const std::filesystem::path& folder,
                          const ExportOptions& requested) {
  ExportOptions options = requested;
  const bool robomimic = options.format == kRobomimic;
  if (robomimic) {
    check_robomimic(options);
    options.motion.approach = ApproachMode::none;
  }
  const store::PlanReader reader(plans);
  Export run{reader, options, StagedFiles(folder), {}, {}};
  run.index.format = options.format;
  run.index.not_verified = options.not_verified;
  run.index.motion = options.motion;
  for (const std::string& selection : options.groups) {
    const JointGroup group = joint_group(reader.robot(), selection);
    if (std::ranges::count(run.index.groups, group.name, &JointGroup::name) > 0)
      throw InputError(fmt::format("--group {}: group '{}' already exists", selection, group.name));
    run.index.groups.push_back(group);
  }
  if (robomimic) export_robomimic(run);
  for (const TextFormat& format : kTextFormats) {
    if (options.format == format.name) export_texts(run, format);
  }
  check_joined(run);
  run.files.add(fmt::format("index_{}.json", options.format),
                index_json(run.index, reader.header(), reader.robot()));
  run.files.commit(options.replace);
  return {run.files.names(), run.index.skipped, run.limits.sentence(run.index.rate_hz),
          run.limits.excess_sentence(reader.robot(), run.index.rate_hz)};
}

}  // namespace morphe::exports
