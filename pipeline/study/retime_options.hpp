#pragma once

#include <cstdint>
#include <string>

#include "core/config/fields.hpp"

namespace morphe::study {

/// The options of configs/studies/retime.yaml.
struct RetimeStudyOptions {
  /// The name of the study.
  std::string study;
  /// The seed of the random paths.
  std::uint64_t seed = 1;
  /// Number of random paths.
  int paths = 2000, quick_paths = 12;
  /// Number of random paths of few joints and waypoints.
  int short_paths = 250000, quick_short_paths = 100;
  /// Number of paths compared with a much finer grid.
  int optimum_paths = 50, quick_optimum_paths = 3;
  /// Pipeline and recordings of the trials, "" for no trials.
  std::string pipeline, manifest;
  /// Maximum number of recordings.
  int trials = 1000, quick_trials = 1;
  /// Factor applied to the limits of a robot that can follow any human.
  double limit_factor = 1000;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RetimeStudyOptions& o) {
  f.required("study", o.study);
  f("seed", o.seed);
  f("paths", o.paths);
  f("quick_paths", o.quick_paths);
  f("short_paths", o.short_paths);
  f("quick_short_paths", o.quick_short_paths);
  f("optimum_paths", o.optimum_paths);
  f("quick_optimum_paths", o.quick_optimum_paths);
  f("pipeline", o.pipeline);
  f("manifest", o.manifest);
  f("trials", o.trials);
  f("quick_trials", o.quick_trials);
  f("limit_factor", o.limit_factor);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const RetimeStudyOptions& options);

}  // namespace morphe::study
