#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace morphe::imports {

/// The two calibration points of a glove sensor: angle = angle_low + (raw - raw_low) * slope.
struct SensorCalibration {
  double raw_low = 0, angle_low = 0, raw_high = 0, angle_high = 0;  ///< angles [rad]
  /// Returns the angle for a raw value [rad].
  double angle(double raw) const {
    return angle_low + (raw - raw_low) * (angle_high - angle_low) / (raw_high - raw_low);
  }
};

/// Reads a calibration by sensor (kGloveSensors) from YAML:
///     ThumbRotate: {raw_low: 0, angle_low: -60 deg, raw_high: 0.42, angle_high: 100 deg}
/// Throws InputError for an unknown sensor, a missing or unknown key and equal raw values.
std::map<std::string, SensorCalibration> read_glove_calibration(const std::filesystem::path& file);

}  // namespace morphe::imports
