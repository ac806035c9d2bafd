#pragma once

#include <cstdint>
#include <string>

#include "core/config/fields.hpp"

namespace morphe::study {

/// configs/studies/retime.yaml.
struct RetimeStudyOptions {
  std::string study;
  std::uint64_t seed = 1;
  int paths = 2000, quick_paths = 12;                 ///< random ones
  int small_paths = 250000, quick_small_paths = 100;  ///< random ones of few joints and waypoints
  int optimum_paths = 50, quick_optimum_paths = 3;    ///< held against a much finer grid
  std::string pipeline, manifest;                     ///< of the trials, none without them
  int trials = 1000, quick_trials = 1;                ///< recordings at most
  double stronger = 1000;  ///< factor of the limits of a robot that can follow any human
};
template <class Fields>
void fields(Fields& f, RetimeStudyOptions& o) {
  f.required("study", o.study);
  f("seed", o.seed);
  f("paths", o.paths);
  f("quick_paths", o.quick_paths);
  f("small_paths", o.small_paths);
  f("quick_small_paths", o.quick_small_paths);
  f("optimum_paths", o.optimum_paths);
  f("quick_optimum_paths", o.quick_optimum_paths);
  f("pipeline", o.pipeline);
  f("manifest", o.manifest);
  f("trials", o.trials);
  f("quick_trials", o.quick_trials);
  f("stronger", o.stronger);
}
std::string why_invalid(const RetimeStudyOptions& options);

}  // namespace morphe::study
