#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

std::string validation_error(const TempoOptions& options) {
  if (!(options.max_duration_ratio >= 1)) return "max_duration_ratio must be at least 1";
  if (!(options.max_tip_error_ratio >= 1)) return "max_tip_error_ratio must be at least 1";
  return "";
}

std::string validation_error(const RepairOptions& options) {
  if (options.attempts < 0) return "attempts must not be negative";
  if (options.max_iterations < 1) return "max_iterations must be at least 1";
  if (options.widen_samples < 1) return "widen_samples must be at least 1";
  if (!(options.range > 0)) return "range must be positive";
  if (options.shortcut_attempts < 0) return "shortcut_attempts must not be negative";
  if (options.pull_back_attempts < 0) return "pull_back_attempts must not be negative";
  if (options.mapping_searches < 0) return "mapping_searches must not be negative";
  if (!(options.extra_clearance >= 0)) return "extra_clearance must not be negative";
  return "";
}

}  // namespace morphe::repair
