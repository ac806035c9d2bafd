#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace morphe::imports {

/// A glove sensor's two calibration points: angle = angle_low + (raw - raw_low) * slope.
struct RawToAngle {
  double raw_low = 0, angle_low = 0, raw_high = 0, angle_high = 0;  ///< angles [rad]
  double angle(double raw) const {
    return angle_low + (raw - raw_low) * (angle_high - angle_low) / (raw_high - raw_low);
  }
};

/// By sensor (kGloveSensors), from YAML:
///
///     ThumbRotate: {raw_low: 0, angle_low: -60 deg, raw_high: 0.42, angle_high: 100 deg}
///
/// InputError for a name that is no sensor, a missing or unknown key and equal raw values.
std::map<std::string, RawToAngle> read_glove_calibration(const std::filesystem::path& file);

}  // namespace morphe::imports
