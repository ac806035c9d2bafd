#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// The options of configs/studies/repair.yaml: movements that are executable without an obstacle
/// are planned again with an obstacle in the robot's way (pipeline/study/obstacles.hpp), by several
/// repair methods. The first method is ours. A case counts as solvable if our method, or the long
/// search with any of its seeds, makes an executable plan. The long search is run only if our
/// method fails, and never with --quick.
struct RepairStudyOptions {
  /// The name of the study and its pipeline config.
  std::string study, pipeline;
  /// Config of pipeline/synthesize.
  std::string synthetic;
  /// The seed of the recordings and obstacles.
  std::uint64_t seed = 1;
  /// Number of movements with an obstacle, each from another recording.
  int cases = 200, quick_cases = 2;
  /// Maximum number of recordings that are tried.
  int recordings = 600;
  /// Index of the first synthetic recording that is tried.
  int first_recording = 0;
  /// The repair methods, ours first.
  std::vector<StudyVariant> variants;
  /// Planner alone, which repairs the path that was executable without the obstacle, without a
  /// mapping.
  StudyVariant planner_only;
  /// The long search.
  StudyVariant long_search;
  /// The seeds of the long search.
  std::vector<std::uint64_t> long_seeds = {1, 2, 3};
  /// Largest displacement of any body between two states of the independent check [m].
  double check_step_m = 1e-4;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RepairStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipeline", o.pipeline);
  f.required("synthetic", o.synthetic);
  f("seed", o.seed);
  f("cases", o.cases);
  f("quick_cases", o.quick_cases);
  f("recordings", o.recordings);
  f("first_recording", o.first_recording);
  f.required("variants", o.variants);
  f.required("planner_only", o.planner_only);
  f.required("long_search", o.long_search);
  f("long_seeds", o.long_seeds);
  f("check_step_m", o.check_step_m);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const RepairStudyOptions& options);

}  // namespace morphe::study
