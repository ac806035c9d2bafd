#pragma once

#include <array>
#include <string>
#include <string_view>

namespace morphe::imports {

/// The label of a column without its unit.
struct ColumnLabel {
  std::string text;
  std::string unit;  ///< as length_unit() or time_unit() name it; "" if absent
};

/// Splits off "(mm)", "[mm]" or a final word that is a unit ("wrist_x_mm"), and outer separators.
ColumnLabel split_unit(std::string label);

/// An interpretation of a label as a point's name and an axis.
struct AxisReading {
  std::string name;  ///< of the point
  int axis = -1;     ///< 0 … 3: x, y, z, w; -1 if the label has no such reading
};

/// Returns the readings with the axis after the name, before it, or as its last character:
/// "wrist_x", "x:wrist", "wristX". Without separators, "x1" is x of "1", and "x" x of "point".
std::array<AxisReading, 3> readings_of(const std::string& label);

/// Returns true if a name denotes a rotation, a velocity, a force or the like, not a point.
bool is_other_quantity(const std::string& name);
/// Returns true for the label of a column of times.
bool is_time_label(const std::string& label);
/// Returns true for the label of a column of frame numbers.
bool is_frame_label(const std::string& label);

/// Returns the text in lower case.
std::string to_lower(std::string_view text);
/// Returns the text without the given characters at both ends.
std::string trim(std::string_view text, std::string_view characters);

}  // namespace morphe::imports
