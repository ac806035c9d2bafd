#include "pipeline/synthesize/synthesize_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace morphe::synthesize {
namespace {

struct NamedRange {
  const char* name;
  const UniformRange& range;
  double least, greatest;
};
std::string range_error_in(std::initializer_list<NamedRange> ranges) {
  for (const auto& [name, range, least, greatest] : ranges) {
    if (range.size() != 2 || !(range[0] <= range[1])) {
      return fmt::format("{}: must be [from, to] with from <= to", name);
    }
    if (range[0] < least || range[1] > greatest) {
      return fmt::format("{}: must lie within {} and {}", name, least, greatest);
    }
  }
  return "";
}

struct NamedNumber {
  const char* name;
  double value, least, greatest;
};
std::string range_error_in(std::initializer_list<NamedNumber> numbers) {
  for (const auto& [name, value, least, greatest] : numbers) {
    if (!(value >= least && value <= greatest)) {
      return fmt::format("{}: must lie within {} and {}, not {}", name, least, greatest, value);
    }
  }
  return "";
}

std::string first_error(std::initializer_list<std::string> faults) {
  for (const std::string& fault : faults) {
    if (!fault.empty()) return fault;
  }
  return "";
}

constexpr double kPi = std::numbers::pi;

}  // namespace

std::string validation_error(const SyntheticSubject& o) {
  return first_error(
      {range_error_in({NamedNumber{"male_share", o.male_share, 0, 1}}),
       range_error_in({NamedRange{"percentiles", o.percentiles, 0, 100},
                       NamedRange{"shoulder_height", o.shoulder_height, 0.15, 0.5}})});
}

std::string validation_error(const KindWeights& o) {
  constexpr double kMaxKindWeight = 1e6;
  const std::string fault =
      range_error_in({NamedNumber{"minimum_jerk", o.minimum_jerk, 0, kMaxKindWeight},
                      NamedNumber{"lognormal", o.lognormal, 0, kMaxKindWeight},
                      NamedNumber{"asymmetric", o.asymmetric, 0, kMaxKindWeight},
                      NamedNumber{"curved", o.curved, 0, kMaxKindWeight},
                      NamedNumber{"two_peaks", o.two_peaks, 0, kMaxKindWeight},
                      NamedNumber{"pause_before_grasp", o.pause_before_grasp, 0, kMaxKindWeight},
                      NamedNumber{"no_grasp", o.no_grasp, 0, kMaxKindWeight}});
  if (!fault.empty()) return fault;
  const double sum = o.minimum_jerk + o.lognormal + o.asymmetric + o.curved + o.two_peaks +
                     o.pause_before_grasp + o.no_grasp;
  return sum > 0 ? "" : "at least one kind must have a weight above 0";
}

std::string validation_error(const SyntheticMovements& o) {
  const std::string fault = first_error(
      {range_error_in(
           {NamedRange{"movements_per_recording", o.movements_per_recording, 1, 1000},
            NamedRange{"rest_s", o.rest_s, 0.3, 60}, NamedRange{"reach_s", o.reach_s, 0.2, 10},
            NamedRange{"grasp_s", o.grasp_s, 0.1, 10},
            NamedRange{"transport_s", o.transport_s, 0.2, 10},
            NamedRange{"hold_s", o.hold_s, 0.1, 60}, NamedRange{"return_s", o.return_s, 0.2, 10},
            NamedRange{"pause_s", o.pause_s, 0.05, 5},
            NamedRange{"distance", o.distance, 0.08, 0.7},
            NamedRange{"direction", o.direction, -kPi / 2, kPi / 2},
            NamedRange{"height", o.height, 0.05, 0.6},
            NamedRange{"elbow_swivel", o.elbow_swivel, -0.2, 1}}),
       range_error_in({NamedNumber{"reach_share", o.reach_share, 0.7, 0.98},
                       NamedNumber{"truncated_start_share", o.truncated_start_share, 0, 1},
                       NamedNumber{"truncated_end_share", o.truncated_end_share, 0, 1}})});
  if (!fault.empty()) return fault;
  for (const double count : o.movements_per_recording) {
    if (count != std::floor(count)) return "movements_per_recording: must be whole numbers";
  }
  return "";
}

std::string validation_error(const SyntheticHand& o) {
  return first_error(
      {range_error_in({NamedRange{"peak_aperture_time", o.peak_aperture_time, 0.3, 0.9},
                       NamedRange{"peak_aperture_excess", o.peak_aperture_excess, 0.005, 0.08}}),
       range_error_in({NamedNumber{"min_aperture_increase", o.min_aperture_increase, 0.005, 0.06},
                       NamedNumber{"pad_depth", o.pad_depth, 0, 0.015}})});
}

std::string validation_error(const SyntheticObject& o) {
  return first_error(
      {range_error_in({NamedRange{"radius", o.radius, 0.01, 0.045},
                       NamedRange{"height", o.height, 0.02, 0.4}}),
       range_error_in({NamedNumber{"tracked_object_share", o.tracked_object_share, 0, 1}})});
}

std::string validation_error(const SyntheticBody& o) {
  return first_error({range_error_in({NamedRange{"tremor_hz", o.tremor_hz, 3, 30}}),
                      range_error_in({NamedNumber{"tremor_amplitude", o.tremor_amplitude, 0, 0.01},
                                      NamedNumber{"drift", o.drift, 0, 0.002}})});
}

std::string validation_error(const SyntheticSensors& o) {
  return first_error(
      {range_error_in({NamedRange{"sensor_offset", o.sensor_offset, 0, 0.2},
                       NamedRange{"dropout_s", o.dropout_s, 0.001, 10}}),
       range_error_in({NamedNumber{"rate_hz", o.rate_hz, 20, 2000},
                       NamedNumber{"position_noise", o.position_noise, 0, 0.1},
                       NamedNumber{"orientation_noise", o.orientation_noise, 0, 0.5},
                       NamedNumber{"correlated_noise_share", o.correlated_noise_share, 0, 1},
                       NamedNumber{"correlation_time_s", o.correlation_time_s, 0.01, 1000},
                       NamedNumber{"dropout_share", o.dropout_share, 0, 0.9},
                       NamedNumber{"calibration_s", o.calibration_s, 0.1, 60},
                       NamedNumber{"digitising_noise", o.digitising_noise, 0, 0.01},
                       NamedNumber{"digitisation_count", static_cast<double>(o.digitisation_count),
                                   1, 1000}})});
}

std::string validation_error(const SyntheticGlove& o) {
  return first_error(
      {range_error_in({NamedRange{"dropout_s", o.dropout_s, 0.001, 10},
                       NamedRange{"clock_offset_s", o.clock_offset_s, -1, 1}}),
       range_error_in(
           {NamedNumber{"rate_hz", o.rate_hz, 5, 2000}, NamedNumber{"noise", o.noise, 0, 0.5},
            NamedNumber{"correlated_noise_share", o.correlated_noise_share, 0, 1},
            NamedNumber{"correlation_time_s", o.correlation_time_s, 0.01, 1000},
            NamedNumber{"bias", o.bias, 0, 1}, NamedNumber{"quantisation", o.quantisation, 0, 0.5},
            NamedNumber{"dropout_share", o.dropout_share, 0, 0.9}})});
}

}  // namespace morphe::synthesize
