#pragma once

#include <array>
#include <string>
#include <string_view>

namespace morphe::imports {

/// What stands above a column, without its unit.
struct ColumnLabel {
  std::string text;
  std::string unit;  ///< mm, cm, m, in; s, ms, us, ns; "" = none
};

/// Takes "(mm)", "[mm]" or a last word that is a unit ("wrist_x_mm") off a label.
ColumnLabel without_unit(std::string label);

/// One way to read a label as a point's name and an axis.
struct AxisReading {
  std::string name;
  int axis = -1;  ///< 0 … 3: x, y, z, w; -1: it cannot be read so
};

/// The axis behind the name, before it, or grown together with it: "wrist_x", "x:wrist", "wristX".
std::array<AxisReading, 3> readings_of(const std::string& label);

/// Whether a name speaks of a rotation, a velocity, a force or the like, not of a point.
bool is_other_quantity(const std::string& name);
bool is_time(const std::string& label);
bool is_frame(const std::string& label);

/// In small letters; without the signs at both ends.
std::string small(std::string_view text);
std::string trim(std::string_view text, std::string_view signs);

}  // namespace morphe::imports
