#include "stages/export/export_plans.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/plan_file.hpp"
#include "stages/export/export_run.hpp"

namespace morphe::exports {
namespace {

/// A format that writes all plans to one file or one dataset.
struct DatasetFormat {
  const char* name;
  void (*write)(ExportRun&);
  double default_rate_hz;  ///< of frames, whose rate is uniform; 0: there are none
  bool may_join;           ///< true if approach and retreat may be joined
  bool has_index;
  SplitBy default_split;
};
constexpr DatasetFormat kDatasetFormats[] = {
    {"robomimic", export_robomimic, 20, false, true, SplitBy::demonstration},
    {"table", export_table, 0, false, false, SplitBy::none},
    {"lerobot", export_lerobot, 30, true, false, SplitBy::none},
};

const DatasetFormat* dataset_format(const std::string& name) {
  const auto found = std::ranges::find(kDatasetFormats, name, &DatasetFormat::name);
  return found == std::end(kDatasetFormats) ? nullptr : &*found;
}

/// Throws InputError for an option that a dataset's format does not have; otherwise sets its rate,
/// its split and its approach.
void complete_options(const DatasetFormat& format, ExportOptions& options) {
  const auto refuse = [&](const char* option, const char* reason) {
    throw InputError(fmt::format("--format {}: {}: omit {}", format.name, reason, option));
  };
  MotionOptions& motion = options.motion;
  if (options.groups != std::vector<std::string>{"all"})
    refuse("--group", "always contains all joints");
  if (motion.delay_s > 0) refuse("--delay", "a wait is not part of a demonstration");
  if (motion.approach == ApproachMode::joined && !format.may_join)
    refuse("--approach", "approach and retreat are not part of a demonstration");
  if (motion.rate_hz > 0 && format.default_rate_hz == 0) refuse("--rate", "contains no motion");
  if (motion.approach == ApproachMode::apart) motion.approach = ApproachMode::none;
  if (motion.rate_hz == 0) motion.rate_hz = format.default_rate_hz;
  motion.uniform = format.default_rate_hz > 0;
  if (options.split.by == SplitBy::none) options.split.by = format.default_split;
}

void check_joined(const ExportRun& run) {
  if (run.options.motion.approach != ApproachMode::joined || run.has_approach_or_retreat ||
      run.index.skipped.size() == run.selection.plans.size())
    return;
  throw InputError(
      "--approach joined: no plan has an approach: plan with the section `approach` "
      "(docs/steps/approach.md), or omit --approach");
}

std::vector<JointGroup> joint_groups(const RobotModel& robot, const ExportOptions& options) {
  std::vector<JointGroup> groups;
  for (const std::string& selection : options.groups) {
    const JointGroup group = joint_group(robot, selection);
    if (std::ranges::count(groups, group.name, &JointGroup::name) > 0)
      throw InputError(fmt::format("--group {}: group '{}' already exists", selection, group.name));
    groups.push_back(group);
  }
  return groups;
}

/// Returns remarks for the user: on the condition, the split, and frames that are no trajectory.
std::vector<std::string> notes_on(const ExportRun& run) {
  std::vector<std::string> notes;
  const ExportOptions& options = run.options;
  if (!options.where.empty())
    notes.push_back(fmt::format("{} of {} satisfy --where", run.selection.plans.size(),
                                count_with_noun(run.reader.size(), "plan")));
  if (options.motion.uniform)
    notes.push_back(fmt::format("{:g} frames per second: for learning, not for execution",
                                options.motion.rate_hz));
  return notes;
}

}  // namespace

std::vector<std::string> export_format_names() {
  std::vector<std::string> names = text_format_names();
  for (const DatasetFormat& format : kDatasetFormats) names.emplace_back(format.name);
  return names;
}

ExportReport export_plans(const std::filesystem::path& plans, const std::filesystem::path& folder,
                          const ExportOptions& requested) {
  ExportOptions options = requested;
  const DatasetFormat* dataset = dataset_format(options.format);
  if (dataset) complete_options(*dataset, options);
  const store::PlanReader reader(plans);
  ExportRun run{
      reader, options, select_plans(reader, options.where, options.split), StagedFiles(folder),
      {},     {}};
  run.index.format = options.format;
  run.index.not_verified = options.not_verified;
  run.index.motion = options.motion;
  run.index.where = options.where;
  run.index.groups = joint_groups(reader.robot(), options);
  if (dataset)
    dataset->write(run);
  else
    export_texts(run);
  check_joined(run);
  if (!dataset || dataset->has_index)
    run.files.add(fmt::format("index_{}.json", options.format),
                  index_json(run.index, reader.header(), reader.robot()));
  run.files.commit(options.replace);
  return {run.files.names(), run.index.skipped, notes_on(run),
          run.limits.sentence(run.index.rate_hz),
          run.limits.excess_sentence(reader.robot(), run.index.rate_hz)};
}

}  // namespace morphe::exports
