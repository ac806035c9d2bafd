// Plans of every shipped recording, turned about the vertical: how far they are from those of the
// recording as it is. The goals are the same to rounding, and so are the paths, because the mapping
// searches on a grid; a re-solve of repair may still end in a neighbouring minimum.
//   bench_facing [--angles N] [--seed S]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "stages/import/guess/heading.hpp"
#include "stages/import/guess/rotate_demonstration.hpp"
#include "stages/import/import.hpp"

namespace morphe {
namespace {

namespace fs = std::filesystem;

double apart(const JointRows& a, const JointRows& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return kInfinity;
  return a.size() > 0 ? (a - b).cwiseAbs().maxCoeff() : 0;
}

/// The most that turned plans are apart from those of the recording as it is.
struct Figures {
  std::size_t plans = 0, other_reason = 0, other_path = 0;  ///< more than a milliradian apart
  double goals_m = 0, path_rad = 0, duration_s = 0,
         upper_arm_rad = 0;  ///< of all with the same reason
};

double duration(const Plan& plan) {
  return plan.trajectory.time.empty() ? 0 : plan.trajectory.time.back();
}

void compare(const run::DemonstrationOutcome& as_is, const run::DemonstrationOutcome& turned,
             Figures& figures) {
  constexpr double kOther = 1e-3;
  for (std::size_t k = 0; k < as_is.plans.size(); ++k) {
    ++figures.plans;
    if (k >= turned.plans.size() || as_is.plans[k].reason != turned.plans[k].reason) {
      ++figures.other_reason;
      continue;
    }
    const Plan &a = as_is.plans[k], &b = turned.plans[k];
    for (std::size_t i = 0; i < a.goals.tip_position.values.size(); ++i) {
      const Vec3 off = a.goals.tip_position.values[i] - b.goals.tip_position.values.at(i);
      figures.goals_m = std::fmax(figures.goals_m, off.norm());
    }
    const double path = apart(a.path.position, b.path.position);
    if (path > kOther) ++figures.other_path;
    figures.path_rad = std::max(figures.path_rad, path);
    figures.duration_s = std::max(figures.duration_s, std::abs(duration(a) - duration(b)));
    figures.upper_arm_rad = std::fmax(
        figures.upper_arm_rad,
        std::abs(a.certificate.upper_arm_error_mean - b.certificate.upper_arm_error_mean));
  }
}

std::vector<double> some_angles(int random, unsigned seed) {
  std::vector<double> angles = {0, std::numbers::pi / 2, std::numbers::pi, -std::numbers::pi / 2};
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-std::numbers::pi, std::numbers::pi);
  for (int k = 0; k < random; ++k) angles.push_back(any(engine));
  return angles;
}

void study(const fs::path& config, const std::vector<fs::path>& recordings,
           const std::vector<double>& angles) {
  const planning::LoadedConfig loaded = planning::load_config(config);
  const planning::PlanningInputs planner{loaded.options, loaded.robot};
  for (const fs::path& file : recordings) {
    imports::ImportRequest request;
    request.paths = {file};
    request.conventions.forward = imports::ForwardSource::recorded;
    imports::import_recordings(request, [&](Demonstration&& recorded) {
      Demonstration demonstration = recorded;
      imports::align_heading({}, demonstration);
      const run::DemonstrationOutcome as_is = planning::plan_demonstration(planner, demonstration);
      Figures figures;
      for (const double angle : angles) {
        Demonstration turned = recorded;
        imports::rotate_about_vertical(turned, angle);
        imports::align_heading({}, turned);
        compare(as_is, planning::plan_demonstration(planner, turned), figures);
      }
      fmt::print(
          "{:<18} {:>3} plans, {} with another reason, goals apart by {:.2g} m, {} on another "
          "path, "
          "apart by {:.2g} rad, {:.2g} s, {:.2g} rad of the upper arm\n",
          demonstration.name, figures.plans, figures.other_reason, figures.goals_m,
          figures.other_path, figures.path_rad, figures.duration_s, figures.upper_arm_rad);
      std::fflush(stdout);
    });
  }
}

}  // namespace
}  // namespace morphe

int main(int argc, char** argv) {
  CLI::App app("Plans of recordings that were turned about the vertical");
  int random = 10;
  unsigned seed = 1;
  app.add_option("--angles", random, "Random angles beside the quarter turns");
  app.add_option("--seed", seed, "Of the angles");
  CLI11_PARSE(app, argc, argv);
  const std::filesystem::path source = MORPHE_SOURCE_DIR;
  const auto datasets = [&](std::initializer_list<const char*> names) {
    std::vector<std::filesystem::path> files;
    for (const char* name : names) files.push_back(source / "datasets" / name / "recordings.yaml");
    return files;
  };
  const std::vector<double> angles = morphe::some_angles(random, seed);
  const auto pipelines = source / "configs/pipelines";
  morphe::study(pipelines / "pa10_dlr_hit2.yaml",
                datasets({"ue-adl", "pyomeca", "kineticstoolkit", "cmu-iclone-bvh", "cmu-native",
                          "pybvh", "dex-retargeting"}),
                angles);
  morphe::study(pipelines / "pa10_dlr_hit2_adroit.yaml", datasets({"adroit-dapg"}), angles);
}
