#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a motion capture table, identified by name in any order.
struct CaptureColumns {
  static constexpr int kNoColumn = -1;  ///< the index of a missing column
  /// The representation of orientations.
  enum class RotationFormat { none, quaternion, euler };

  /// The columns of a point or body: `NAME_x_m`, `_y_m`, `_z_m` (m, cm, mm, in, or no suffix), and
  /// for a tracked body `NAME_qw` … `_qz` or `NAME_azimuth_deg`, `_elevation_deg`, `_roll_deg` (deg
  /// or rad). A point `NAME_joint`, the joint centre at the sensor NAME, is called NAME.
  struct Body {
    std::string name;
    std::array<int, 3> position{kNoColumn, kNoColumn, kNoColumn};  ///< columns of x, y, z
    std::string unit;                                              ///< "" if absent in the file
    RotationFormat rotation_format = RotationFormat::none;
    /// Columns of qw … qz, or of three angles.
    std::array<int, 4> rotation{kNoColumn, kNoColumn, kNoColumn, kNoColumn};
    double radians_per_unit = 1;  ///< of the Euler angles
  };
  /// A column of a glove: `SENSOR_deg`, `_rad` or `_raw` with SENSOR of kGloveSensors.
  struct GloveSensor {
    int sensor = 0;  ///< index in kGloveSensors
    int column = kNoColumn;
    enum class Unit { radians, degrees, raw } unit = Unit::radians;
  };

  std::vector<std::string> names;           ///< [count] of all columns
  int time = kNoColumn, frame = kNoColumn;  ///< `time_s` and `frame`
  std::vector<Body> bodies, points;         ///< with and without a rotation
  std::vector<GloveSensor> glove;           ///< in the order of kGloveSensors
  std::vector<std::string> left_out;        ///< names of all other columns
  std::vector<std::string> notes;           ///< on repeated names
};

/// Reads the header, line 1. `renamed` maps recorded names of bodies, points and glove sensors to
/// Morphe's; keys that occur are added to `used`. Repeated names are
/// numbered. Throws InputError for missing columns, two rotations of a body, and missing or
/// inconsistent units.
CaptureColumns read_capture_columns(const files::CsvText& csv,
                                    const std::map<std::string, std::string>& renamed,
                                    std::vector<std::string>& used);

}  // namespace morphe::imports
