#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// configs/studies/repair.yaml: movements that are executable as they are, planned again with an
/// obstacle put into the robot's way (pipeline/study/obstacles.hpp), by several ways of repairing.
/// The first is ours; a case counts as solvable if it, or the long search with any of its seeds,
/// makes an executable plan. The long search is only run where ours fails, and never
/// with --quick.
struct RepairStudyOptions {
  std::string study, pipeline;
  std::string synthetic;  ///< a config of pipeline/synthesize
  std::uint64_t seed = 1;
  int cases = 200, quick_cases = 2;  ///< movements with an obstacle, each of another recording
  int recordings = 600;              ///< at most looked at for them
  int first_recording = 0;           ///< looked at, of the synthetic ones
  std::vector<StudyVariant> variants;
  StudyVariant plain;  ///< repairs what was executable before the obstacle came, without a mapping
  StudyVariant long_search;
  std::vector<std::uint64_t> long_seeds = {1, 2, 3};
  double step_m = 1e-4;  ///< no body moves farther between two states of the independent check
};
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
  f.required("plain", o.plain);
  f.required("long_search", o.long_search);
  f("long_seeds", o.long_seeds);
  f("step_m", o.step_m);
}
std::string why_invalid(const RepairStudyOptions& options);

}  // namespace morphe::study
