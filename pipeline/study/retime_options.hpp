#pragma once

#include <cstdint>
#include <string>

#include "core/config/fields.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::study {

/// The options of configs/studies/retime.yaml.
struct RetimeStudyOptions {
  std::string study;
  std::uint64_t seed = 1;
  int paths = 2000, quick_paths = 12;                 ///< number of random paths
  int short_paths = 250000, quick_short_paths = 100;  ///< those of few joints and waypoints
  int optimum_paths = 50, quick_optimum_paths = 3;    ///< those compared with the shortest time
  std::string pipeline, manifest;       ///< pipeline and recordings of the trials, "" for no trials
  int trials = 1000, quick_trials = 1;  ///< maximum number of recordings
  double limit_factor = 1000;           ///< for the limits of a robot that can follow any human
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RetimeStudyOptions& o) {
  f.required("study", o.study);
  f("seed", o.seed);
  f("paths", o.paths, bounds::kCount);
  f("quick_paths", o.quick_paths, bounds::kCount);
  f("short_paths", o.short_paths, bounds::kCount);
  f("quick_short_paths", o.quick_short_paths, bounds::kCount);
  f("optimum_paths", o.optimum_paths, bounds::kCount);
  f("quick_optimum_paths", o.quick_optimum_paths, bounds::kCount);
  f("pipeline", o.pipeline);
  f("manifest", o.manifest);
  f("trials", o.trials, bounds::kCountOrNone);
  f("quick_trials", o.quick_trials, bounds::kCountOrNone);
  f("limit_factor", o.limit_factor, bounds::kFactorFrom1);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const RetimeStudyOptions& options);

}  // namespace morphe::study
