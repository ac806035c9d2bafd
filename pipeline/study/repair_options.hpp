#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// The options of configs/studies/repair.yaml: movements that are executable without an obstacle
/// are planned again with an obstacle in the robot's way (obstacles.hpp), by several repair
/// methods. A case is solvable if our method, the long search with any of its seeds, or the method
/// that is judged makes an executable plan. The long search runs only if our method fails, not with
/// --quick.
struct RepairStudyOptions {
  std::string study, pipeline;
  std::string synthetic;               ///< config of pipeline/synthesize
  std::uint64_t seed = 1;              ///< seed of the recordings and obstacles
  int cases = 200, quick_cases = 2;    ///< movements with an obstacle, each from another recording
  int recordings = 600;                ///< maximum number of recordings that are tried
  int first_recording = 0;             ///< index of the first synthetic recording that is tried
  std::vector<StudyVariant> variants;  ///< repair methods, ours first
  /// Planner alone, which repairs the path that was executable without the obstacle.
  StudyVariant planner_only;
  StudyVariant long_search;
  std::vector<std::uint64_t> long_seeds = {1, 2, 3};
  double check_step_m = 1e-4;  ///< motion of any body between two states of the independent check
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RepairStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipeline", o.pipeline);
  f.required("synthetic", o.synthetic);
  f("seed", o.seed);
  f("cases", o.cases, bounds::kCount);
  f("quick_cases", o.quick_cases, bounds::kCount);
  f("recordings", o.recordings, bounds::kCount);
  f("first_recording", o.first_recording, bounds::kCountOrNone);
  f.required("variants", o.variants);
  f.required("planner_only", o.planner_only);
  f.required("long_search", o.long_search);
  f("long_seeds", o.long_seeds);
  f("check_step_m", o.check_step_m, bounds::kLength.from(1e-6));
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const RepairStudyOptions& options);

}  // namespace morphe::study
