#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

std::string validation_error(const RepairOptions& options) {
  if (options.attempts < 0) return "attempts must not be negative";
  if (options.iterations < 1) return "iterations must be at least 1";
  if (options.widen_samples < 1) return "widen_samples must be at least 1";
  if (!(options.range > 0)) return "range must be positive";
  if (options.shortcut_attempts < 0) return "shortcut_attempts must not be negative";
  if (options.draw_attempts < 0) return "draw_attempts must not be negative";
  if (options.searches < 0) return "searches must not be negative";
  if (!(options.extra_clearance >= 0)) return "extra_clearance must not be negative";
  return "";
}

}  // namespace morphe::repair
