#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// Where a table of a motion capture by name has what; columns in any order. kNone = no column.
struct CaptureColumns {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  enum class Turn { none, quaternion, euler };

  /// `NAME_x_m`, `_y_m`, `_z_m` (m, cm, mm, in, or no suffix), and for a tracked body
  /// `NAME_qw` … `_qz` or `NAME_azimuth_deg`, `_elevation_deg`, `_roll_deg` (deg or rad). A point
  /// `NAME_joint` is called NAME: the joint centre digitised beside the sensor of that name.
  struct Body {
    std::string name;
    std::array<std::size_t, 3> position{kNone, kNone, kNone};
    std::string unit;  ///< "" = the file does not say
    Turn turn = Turn::none;
    std::array<std::size_t, 4> rotation{kNone, kNone, kNone, kNone};
    double radians = 1;  ///< in one unit of the Euler angles
  };
  /// `SENSOR_deg`, `_rad` or `_raw` of kGloveSensors.
  struct GloveSensor {
    std::size_t sensor = 0;  ///< of kGloveSensors
    std::size_t column = kNone;
    enum class Unit { radians, degrees, raw } unit = Unit::radians;
  };

  std::vector<std::string> names;           ///< [count]
  std::size_t time = kNone, frame = kNone;  ///< `time_s`, `frame`: one of them at least
  std::vector<Body> bodies, points;         ///< with and without a rotation
  std::vector<GloveSensor> glove;           ///< in the order of kGloveSensors
  std::vector<std::string> left_out;        ///< columns that are none of these
};

/// Reads the header, line 1; `renamed` maps recorded names of bodies, points and glove sensors to
/// ours, and what it was used for goes into `used`. InputError for a column that stands twice, a
/// body or point that lacks one, one with two rotations, a glove sensor without a unit.
CaptureColumns read_capture_columns(const files::CsvText& csv,
                                    const std::map<std::string, std::string>& renamed,
                                    std::vector<std::string>& used);

}  // namespace morphe::imports
