#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/study/paper_cases.hpp"

namespace morphe::study {
namespace {

struct PaperCase {
  const char* name;
  void (*run)(const PaperContext&, StudyResult&);
};
constexpr std::array<PaperCase, 7> kCases{{{"table_1", run_table_1},
                                           {"tracking", run_tracking},
                                           {"fingers", run_fingers},
                                           {"scales", run_scales},
                                           {"terms", run_terms},
                                           {"mappings", run_mappings},
                                           {"reference", run_reference}}};

}  // namespace

std::string validation_error(const PaperStudyOptions& o) {
  for (const std::string& name : o.cases) {
    if (std::ranges::none_of(kCases, [&](const PaperCase& c) { return name == c.name; }))
      return fmt::format("cases: unknown case '{}'", name);
  }
  return "";
}

StudyResult paper_study(const config::ConfigNode& config, const StudyRun& run) {
  PaperContext context;
  PaperStudyOptions& options = context.options;
  config::read_document(config, options);
  const std::filesystem::path folder = run.config.parent_path();
  const double step_s = run.quick ? options.quick_step_s : options.step_s;
  const human::ArmLengths arm{options.upper_arm, options.forearm};
  context.robots = folder / options.robots;
  context.arms = arm_poses(folder / options.arm_motions, arm, step_s);
  context.tips = arm_poses(folder / options.tip_motions, arm, step_s);
  context.hands = hand_poses(folder / options.hand_motions,
                             {options.hand_length, options.hand_breadth}, step_s);
  context.weights = {options.tip_position, options.tip_orientation, options.humanlike};
  StudyResult result;
  for (const PaperCase& paper_case : kCases) {
    const auto& selected = options.cases;
    if (!selected.empty() && std::ranges::count(selected, paper_case.name) == 0) continue;
    run.progress(paper_case.name);
    paper_case.run(context, result);
  }
  return result;
}

}  // namespace morphe::study
