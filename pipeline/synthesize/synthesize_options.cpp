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
std::string range_error(std::initializer_list<NamedRange> ranges) {
  for (const auto& [name, range, least, greatest] : ranges) {
    if (range.size() != 2 || !(range[0] <= range[1]))
      return fmt::format("{}: must be [from, to] with from <= to", name);
    if (range[0] < least || range[1] > greatest)
      return fmt::format("{}: must lie within {} and {}", name, least, greatest);
  }
  return "";
}

struct NamedNumber {
  const char* name;
  double value, least, greatest;
};
std::string number_error(std::initializer_list<NamedNumber> numbers) {
  for (const auto& [name, value, least, greatest] : numbers)
    if (!(value >= least && value <= greatest))
      return fmt::format("{}: must lie within {} and {}, not {}", name, least, greatest, value);
  return "";
}

std::string first_error(std::initializer_list<std::string> errors) {
  for (const std::string& error : errors)
    if (!error.empty()) return error;
  return "";
}

constexpr double kPi = std::numbers::pi;

}  // namespace

std::string validation_error(const SyntheticSubject& o) {
  return first_error({number_error({{"male_share", o.male_share, 0, 1}}),
                      range_error({{"percentiles", o.percentiles, 0, 100},
                                   {"shoulder_height", o.shoulder_height, 0.15, 0.5}})});
}

std::string validation_error(const KindWeights& o) {
  constexpr double kMaxKindWeight = 1e6;
  const std::string error =
      number_error({{"minimum_jerk", o.minimum_jerk, 0, kMaxKindWeight},
                    {"lognormal", o.lognormal, 0, kMaxKindWeight},
                    {"asymmetric", o.asymmetric, 0, kMaxKindWeight},
                    {"curved", o.curved, 0, kMaxKindWeight},
                    {"two_peaks", o.two_peaks, 0, kMaxKindWeight},
                    {"pause_before_grasp", o.pause_before_grasp, 0, kMaxKindWeight},
                    {"no_grasp", o.no_grasp, 0, kMaxKindWeight}});
  if (!error.empty()) return error;
  const double sum = o.minimum_jerk + o.lognormal + o.asymmetric + o.curved + o.two_peaks +
                     o.pause_before_grasp + o.no_grasp;
  return sum > 0 ? "" : "at least one kind must have a weight above 0";
}

std::string validation_error(const SyntheticMovements& o) {
  const std::string error =
      first_error({range_error({{"movements_per_recording", o.movements_per_recording, 1, 1000},
                                {"rest_s", o.rest_s, 0.3, 60},
                                {"reach_s", o.reach_s, 0.2, 10},
                                {"grasp_s", o.grasp_s, 0.1, 10},
                                {"transport_s", o.transport_s, 0.2, 10},
                                {"hold_s", o.hold_s, 0.1, 60},
                                {"return_s", o.return_s, 0.2, 10},
                                {"pause_s", o.pause_s, 0.05, 5},
                                {"distance", o.distance, 0.08, 0.7},
                                {"direction", o.direction, -kPi / 2, kPi / 2},
                                {"height", o.height, 0.05, 0.6},
                                {"elbow_swivel", o.elbow_swivel, -0.2, 1}}),
                   number_error({{"reach_share", o.reach_share, 0.7, 0.98},
                                 {"truncated_start_share", o.truncated_start_share, 0, 1},
                                 {"truncated_end_share", o.truncated_end_share, 0, 1}})});
  if (!error.empty()) return error;
  for (const double count : o.movements_per_recording)
    if (count != std::floor(count)) return "movements_per_recording: must be whole numbers";
  return "";
}

std::string validation_error(const SyntheticHand& o) {
  return first_error({range_error({{"peak_aperture_time", o.peak_aperture_time, 0.3, 0.9},
                                   {"peak_aperture_excess", o.peak_aperture_excess, 0.005, 0.08}}),
                      number_error({{"min_aperture_increase", o.min_aperture_increase, 0.005, 0.06},
                                    {"pad_depth", o.pad_depth, 0, 0.015}})});
}

std::string validation_error(const SyntheticObject& o) {
  return first_error(
      {range_error({{"radius", o.radius, 0.01, 0.045}, {"height", o.height, 0.02, 0.4}}),
       number_error({{"tracked_object_share", o.tracked_object_share, 0, 1}})});
}

std::string validation_error(const SyntheticBody& o) {
  return first_error({range_error({{"tremor_hz", o.tremor_hz, 3, 30}}),
                      number_error({{"tremor_amplitude", o.tremor_amplitude, 0, 0.01},
                                    {"drift", o.drift, 0, 0.002}})});
}

std::string validation_error(const SyntheticSensors& o) {
  return first_error(
      {range_error(
           {{"sensor_offset", o.sensor_offset, 0, 0.2}, {"dropout_s", o.dropout_s, 0.001, 10}}),
       number_error({{"rate_hz", o.rate_hz, 20, 2000},
                     {"position_noise", o.position_noise, 0, 0.1},
                     {"orientation_noise", o.orientation_noise, 0, 0.5},
                     {"correlated_noise_share", o.correlated_noise_share, 0, 1},
                     {"correlation_time_s", o.correlation_time_s, 0.01, 1000},
                     {"dropout_share", o.dropout_share, 0, 0.9},
                     {"calibration_s", o.calibration_s, 0.1, 60},
                     {"digitising_noise", o.digitising_noise, 0, 0.01},
                     {"digitisation_count", static_cast<double>(o.digitisation_count), 1, 1000}})});
}

std::string validation_error(const SyntheticGlove& o) {
  return first_error({range_error({{"dropout_s", o.dropout_s, 0.001, 10},
                                   {"clock_offset_s", o.clock_offset_s, -1, 1}}),
                      number_error({{"rate_hz", o.rate_hz, 5, 2000},
                                    {"noise", o.noise, 0, 0.5},
                                    {"correlated_noise_share", o.correlated_noise_share, 0, 1},
                                    {"correlation_time_s", o.correlation_time_s, 0.01, 1000},
                                    {"bias", o.bias, 0, 1},
                                    {"quantisation", o.quantisation, 0, 0.5},
                                    {"dropout_share", o.dropout_share, 0, 0.9}})});
}

}  // namespace morphe::synthesize
