#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a motion capture table, identified by name in any order. kNoColumn stands for a
/// missing column.
struct CaptureColumns {
  static constexpr std::size_t kNoColumn = -1;  ///< a missing column
  /// The representation of orientations.
  enum class RotationFormat { none, quaternion, euler };

  /// The columns of a point or body: `NAME_x_m`, `_y_m`, `_z_m` (m, cm, mm, in, or no suffix), and
  /// for a tracked body `NAME_qw` … `_qz` or `NAME_azimuth_deg`, `_elevation_deg`, `_roll_deg` (deg
  /// or rad). A point `NAME_joint` is named NAME: the joint centre digitised beside the sensor of
  /// that name.
  struct Body {
    std::string name;
    std::array<std::size_t, 3> position{kNoColumn, kNoColumn, kNoColumn};  ///< columns of x, y, z
    std::string unit;  ///< "" if absent in the file
    RotationFormat rotation_format = RotationFormat::none;
    /// Columns of qw … qz, or of three angles.
    std::array<std::size_t, 4> rotation{kNoColumn, kNoColumn, kNoColumn, kNoColumn};
    double radians_per_unit = 1;  ///< radians in one unit of the Euler angles
  };
  /// A column of a glove: `SENSOR_deg`, `_rad` or `_raw` with SENSOR of kGloveSensors.
  struct GloveSensor {
    std::size_t sensor = 0;          ///< index in kGloveSensors
    std::size_t column = kNoColumn;  ///< column of its values
    enum class Unit { radians, degrees, raw } unit = Unit::radians;
  };

  std::vector<std::string> names;  ///< [count] names of all columns
  /// `time_s` and `frame`, of which at least one exists.
  std::size_t time = kNoColumn, frame = kNoColumn;
  std::vector<Body> bodies, points;   ///< with and without a rotation
  std::vector<GloveSensor> glove;     ///< in the order of kGloveSensors
  std::vector<std::string> left_out;  ///< other columns
};

/// Reads the header, line 1. `renamed` maps recorded names of bodies, points and glove sensors to
/// ours; names to which it was applied are added to `used`. Throws InputError for a repeated
/// column, a body or point with a missing column, one with two rotations, and a glove sensor
/// without a unit.
CaptureColumns read_capture_columns(const files::CsvText& csv,
                                    const std::map<std::string, std::string>& renamed,
                                    std::vector<std::string>& used);

}  // namespace morphe::imports
