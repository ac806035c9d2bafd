#include "pipeline/synthesize/synthesize_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

namespace morphe::synthesize {
namespace {

/// Returns the error of the first range that is not [from, to], or "".
std::string range_error(std::initializer_list<std::pair<const char*, const UniformRange&>> ranges) {
  for (const auto& [name, range] : ranges)
    if (range.size() != 2 || !(range[0] <= range[1]))
      return fmt::format("{}: must be [from, to] with from <= to", name);
  return "";
}

}  // namespace

std::string validation_error(const SyntheticSubject& o) {
  return range_error({{"percentiles", o.percentiles}, {"shoulder_height", o.shoulder_height}});
}

std::string validation_error(const KindWeights& o) {
  const double sum = o.minimum_jerk + o.lognormal + o.asymmetric + o.curved + o.two_peaks +
                     o.pause_before_grasp + o.no_grasp;
  return sum > 0 ? "" : "at least one kind must have a weight above 0";
}

std::string validation_error(const SyntheticMovements& o) {
  const std::string error = range_error({{"movements_per_recording", o.movements_per_recording},
                                         {"rest_s", o.rest_s},
                                         {"reach_s", o.reach_s},
                                         {"grasp_s", o.grasp_s},
                                         {"transport_s", o.transport_s},
                                         {"hold_s", o.hold_s},
                                         {"return_s", o.return_s},
                                         {"pause_s", o.pause_s},
                                         {"distance", o.distance},
                                         {"direction", o.direction},
                                         {"height", o.height},
                                         {"elbow_swivel", o.elbow_swivel}});
  if (!error.empty()) return error;
  for (const double count : o.movements_per_recording)
    if (count != std::floor(count)) return "movements_per_recording: must be whole numbers";
  return "";
}

std::string validation_error(const SyntheticHand& o) {
  return range_error({{"peak_aperture_time", o.peak_aperture_time},
                      {"peak_aperture_excess", o.peak_aperture_excess}});
}

std::string validation_error(const SyntheticObject& o) {
  return range_error({{"radius", o.radius}, {"height", o.height}});
}

std::string validation_error(const SyntheticBody& o) {
  return range_error({{"tremor_hz", o.tremor_hz}});
}

std::string validation_error(const SyntheticSensors& o) {
  return range_error({{"sensor_offset", o.sensor_offset}, {"dropout_s", o.dropout_s}});
}

std::string validation_error(const SyntheticGlove& o) {
  return range_error({{"dropout_s", o.dropout_s}, {"clock_offset_s", o.clock_offset_s}});
}

}  // namespace morphe::synthesize
